// What ESLint asks of the scripts of the pages and of their tests: no name that nothing defines, and none that nothing
// uses. The packages are those that `.ci/run` installs below `target`.
import { createRequire } from 'node:module';

const globals = createRequire(new URL('../target/eslint/', import.meta.url))('globals');
const rules = { 'no-undef': 'error', 'no-unused-vars': ['error', { vars: 'local' }] };

export default [
    {
        // The builder joins these files to one script, in which each sees what the others define.
        files: ['*.js', 'live/page/**/*.js'],
        languageOptions: {
            sourceType: 'script',
            globals: { ...globals.browser, live: 'readonly', bindModule: 'readonly', liveWorker: 'readonly', katex: 'readonly' },
        },
        rules,
    },
    {
        files: ['**/*.mjs'],
        languageOptions: { globals: globals.node },
        rules,
    },
];
