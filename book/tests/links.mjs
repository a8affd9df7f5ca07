// Whether each link of the built pages leads to a file that is there, and to a heading that it has, and
// whether the book is read without a network: node links.mjs target/book
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';

const book = process.argv[2];
const read = (page) => readFileSync(page, 'utf8');
const files = readdirSync(book, { recursive: true }).map((name) => join(book, name));
const pages = files.filter((name) => name.endsWith('.html'));

// Values of attributes, as written; the ids of a page are those that a link may name after a #.
const values = (html, attribute) =>
    [...html.matchAll(new RegExp(`<[^>]*\\s(?:${attribute})="([^"]*)"`, 'g'))].map((found) => found[1]);
const ids = new Map(pages.map((page) => [page, new Set(values(read(page), 'id'))]));

let links = 0;
const dead = [];
for (const page of pages) {
    for (const link of values(read(page), 'href|src')) {
        const [path, heading] = decodeURI(link).split('#');
        // Other sites are not asked; the links of the page for missing pages begin at the root of a server.
        if (/^(\w+:|\/)/.test(path)) continue;
        links += 1;
        const target = path ? join(dirname(page), path.split('?')[0]) : page;
        if (!existsSync(target) || (heading && ids.has(target) && !ids.get(target).has(heading))) {
            dead.push(`${relative(book, page)}: ${link}`);
        }
    }
}

// A reader may follow a link into the network; a page or a style sheet loads nothing from there.
const loading = /<(?:link|script|img|iframe|source)\s[^>]*(?:href|src)="(?:https?:)?\/\/[^>]*>|url\(["' ]*(?:https?:)?\/\/[^)]*\)/g;
for (const file of files.filter((name) => /\.(html|css)$/.test(name))) {
    for (const [loaded] of read(file).matchAll(loading)) {
        dead.push(`${relative(book, file)} loads from the network: ${loaded}`);
    }
}
console.log(`${links} links of ${pages.length} pages: ${dead.length ? 'dead are' : 'none is dead'}`);
dead.forEach((link) => console.log(link));
process.exit(dead.length || !links ? 1 : 0);
