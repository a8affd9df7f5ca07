// Renders every locked picture with the WebAssembly module, by lesson and by engine,
// also from its scene file, and compares the hashes with the locks: node pictures.mjs MODULE.wasm
import { readFileSync, readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const top = fileURLToPath(new URL('../../../', import.meta.url));
const text = (path) => readFileSync(path, 'utf8');

const bindModule = new Function(`${text(`${top}book/live/page/binding.js`)}; return bindModule;`)();
const { instance } = await WebAssembly.instantiate(readFileSync(process.argv[2]), {});
const ask = bindModule(instance.exports);

const pictures = new Set(ask('pictures', []).text.split('\n'));
let wrong = 0;
const complain = (complaint) => {
    wrong += 1;
    console.log(complaint);
};

// A picture, and for a scene of shapes the picture of its scene file.
let files = 0;
const checkAll = (picture, lock) => {
    check(picture, lock);
    if (/^a0[4-7]/.test(picture)) {
        files += 1;
        check(`file\n${ask(`export ${picture}`, []).text}`, lock, `${picture} from its file`);
    }
};

const check = (picture, lock, name = picture) => {
    const { settings } = ask(`about ${picture}`, []);
    for (const [engine, renderer] of ['lesson', 'engine'].entries()) {
        const hash = ask(`render ${picture}`, [...settings.slice(0, 6), engine, 0, 0, 1]).text;
        if (hash !== lock) {
            complain(`${name}, ${renderer}: ${hash}, locked ${lock}`);
        }
    }
};

let locks = 0;
for (const stage of readdirSync(top).filter((name) => name.startsWith('a0'))) {
    const folder = `${top}${stage}/tests/snapshots`;
    for (const file of readdirSync(folder).filter((name) => name.endsWith('.snap'))) {
        // The last stage also has the locks of the errata and of go-wrong.
        const names = [stage, 'errata', 'go-wrong'].map((group) => `${group}-${file.slice(0, -5)}`);
        const picture = names.find((name) => pictures.has(name));
        locks += 1;
        if (picture) {
            checkAll(picture, /^hash (\w+)$/m.exec(text(`${folder}/${file}`))[1]);
        } else {
            complain(`the module has no picture of ${stage}/tests/snapshots/${file}`);
        }
    }
}
if (locks !== pictures.size) {
    complain(`${pictures.size} pictures, but ${locks} locks`);
}
console.log(`${locks} pictures and ${files} scene files by lesson and engine on wasm32: ${wrong ? `${wrong} complaints` : 'all have the locked bytes'}`);
process.exit(wrong ? 1 : 0);
