// The built book in a headless Chromium, opened as files: every live picture has the
// locked bytes, every formula is drawn, every figure answers, and without WebAssembly the pictures stand.
//
//     node browser.mjs CHROMIUM ANSWERS [FOLDER FOR SCREENSHOTS]
//
// ANSWERS is the program of examples/answers.rs, which computes the figures' numbers
// natively. Two browsers share the pages, each driven by a thread that runs this file.
import { execFile, spawnSync } from 'node:child_process';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { promisify } from 'node:util';
import { Worker, isMainThread, parentPort, workerData } from 'node:worker_threads';
import { Chromium } from './chromium.mjs';
import { tryMeasure } from './measure.mjs';
import { tryExtremes, tryLeftOut, tryOwnCurve } from './wishes.mjs';

const [program, answers, screenshots] = process.argv.slice(2);
const top = new URL('../../../', import.meta.url);
const stages = readdirSync(top).filter((name) => /^a0\d/.test(name));
const book = new URL('../../../target/book/', import.meta.url);
const all = readdirSync(book)
    .filter((name) => name.endsWith('.html') && !['print.html', 'toc.html', '404.html', 'index.html'].includes(name));

const texts = all.map((page) => [page, readFileSync(new URL(page, book), 'utf8')]);
const firstPage = (picture) => texts.find(([, text]) => text.includes(`/${picture}.png"`))?.[0];

const run = promisify(execFile);
const complaints = [];
const expect = (isSo, complaint) => {
    if (!isSo) {
        complaints.push(complaint);
        console.log(complaint);
    }
};

const browsers = 2;
// The pages that no browser has taken yet.
const taken = new Int32Array(workerData?.taken ?? new SharedArrayBuffer(4));
function* untested() {
    for (let index; (index = Atomics.add(taken, 0, 1)) < all.length;) {
        yield all[index];
    }
}
const chromium = isMainThread ? undefined : new Chromium(program);
const open = async (page) => {
    await chromium.go(new URL(page, book).href);
    await chromium.value(`document.querySelectorAll('details').forEach((fold) => (fold.open = true))`);
};
const shot = async (name, element) => {
    if (screenshots) {
        writeFileSync(`${screenshots}/${name}.png`, Buffer.from(await chromium.picture(element), 'base64'));
    }
};

// The scene `phong` by a real click, then turned by mouse and keys, and reset.
async function tryByHand() {
    await open('a05-lighting.html');
    const picture = `live.pictures.find(({ name }) => name === 'a05-lighting-phong')`;
    const start = performance.now();
    await chromium.click(`${picture}.frame`);
    await chromium.until(`${picture}.frame.dataset.state`);
    console.log(`first picture ${(performance.now() - start).toFixed(0)} ms after the click: ${await chromium.value(`${picture}.status.value`)}`);
    expect((await chromium.value(`${picture}.frame.dataset.state`)) === 'tested', 'phong has other bytes after a click');
    await chromium.until(`${picture}.controls`);

    await chromium.drag(`${picture}.canvas`, 60, 20);
    await chromium.until(`${picture}.frame.dataset.state === 'changed'`);
    const yaw = await chromium.value(`${picture}.settings.yaw`);
    expect(yaw !== 0, 'a drag does not turn the camera');
    await chromium.key('ArrowLeft');
    expect((await chromium.value(`${picture}.settings.yaw`)) > yaw, 'the arrow keys do not turn the camera');
    await shot('phong-turned', `${picture}.frame.closest('p')`);
    const [x, y] = await chromium.middle(`${picture}.canvas`);
    await chromium.mouse('mouseMoved', x + 3, y + 3);
    await chromium.until(`/^Pixel .*t = /.test(${picture}.probed.value)`);
    await chromium.key('0');
    await chromium.until(`${picture}.frame.dataset.state === 'tested'`);
    expect(!(await chromium.value(`${picture}.explained`)), 'a drag explains a pixel');
    await chromium.click(`${picture}.canvas`);
    await chromium.until(`${picture}.explained.shadow.querySelector('.ray1')`);
    // Each view shows its part of the drawing, and nothing beside it.
    const shapes = await chromium.value(`[...${picture}.explained.shadow.querySelectorAll('svg')].map((svg) => {
        const { width, height } = svg.getBoundingClientRect();
        return (width / height) / (svg.viewBox.baseVal.width / svg.viewBox.baseVal.height);
    })`);
    expect(shapes.length === 2 && shapes.every((shape) => Math.abs(shape - 1) < 0.01), `the views of a pixel's rays have ${shapes} times their shape`);
    const station = () => chromium.value(`${picture}.explained.where.value`);
    const first = await station();
    await chromium.key('ArrowRight');
    expect((await station()) !== first, 'an arrow key does not go to the next ray');
    await chromium.key('ArrowLeft');
    expect((await station()) === first, 'an arrow key does not go back');
    await shot('explained', `${picture}.explained.root`);
    await chromium.key('Escape');

    // A slider keeps its keys, with which the book would turn the page.
    await chromium.value(`${picture}.frame.parentElement.querySelector('.live-controls input').focus()`);
    await chromium.arrow('ArrowRight', 39);
    expect((await chromium.value(`${picture}.settings.samples`)) === 4, 'the slider of the samples does not answer the keyboard');
    expect(/a05-lighting/.test(await chromium.value('location.href')), 'an arrow key in a slider turns the page');
}

// The pictures with these names of a page.
async function tryPictures(page, names) {
    const states = await chromium.value(`(async () => {
        const states = [];
        for (const picture of live.pictures.filter(({ name }) => ${JSON.stringify(names)}.includes(name))) {
            await picture.begin();
            states.push([picture.name, picture.frame.dataset.state, picture.status.value]);
        }
        return states;
    })()`);
    for (const [name, state, status] of states) {
        expect(state === 'tested', `${page}, ${name}: ${status}`);
    }
}

// KaTeX has drawn each formula of the page.
async function tryFormulas(page) {
    const undrawn = await chromium.value(`[...document.querySelectorAll('.formula')]
        .filter((formula) => !formula.querySelector('.katex')).map(({ textContent }) => textContent)`);
    expect(!undrawn.length, `${page}, not drawn: ${undrawn}`);
}

// Pixels of the traced pictures with these names: each ray shows the numbers that the command prints.
// Returns how many.
async function tryPixels(names) {
    const traced = await chromium.value(`live.pictures.map(({ about, name }) => (about?.turns[0] ? [name, ...about.settings] : ["", 0, 0]))`);
    let pixels = 0;
    for (const [index, [name, width, height]] of traced.entries()) {
        const stage = stages.find((stage) => name.startsWith(`${stage}-`));
        if (!stage || !names.includes(name)) {
            continue;
        }
        // Once, though a page may show it again.
        names = names.filter((other) => other !== name);
        const explain = new URL(`../${stage}`, pathToFileURL(resolve(answers))).pathname;
        const places = [[0.5, 0.5], [0.16, 0.84], [0.78, 0.62]].map(([x, y]) => [Math.floor(x * width), Math.floor(y * height)]);
        const printed = places.map((pixel) => run(explain, ['explain', name.slice(stage.length + 1), '--pixel', `${pixel}`, '--json']));
        for (const [pixel, { stdout }] of (await Promise.all(printed)).map((output, index) => [places[index], output])) {
            const [shown, printed, status] = await chromium.value(`(async ({ steps }) => {
                const picture = live.pictures[${index}];
                await picture.explain(${pixel});
                const { explained } = picture;
                const shown = explained.rays.flatMap(() => {
                    const texts = [...explained.list.querySelectorAll('span')].map((span) => span.textContent);
                    explained.root.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowRight' }));
                    return texts;
                });
                const printed = steps.flatMap(({ values }) => Object.entries(values).map(([symbol, list]) =>
                    list.length === 1 ? \`\${symbol} = \${live.show(list[0])}\` : \`\${symbol} = (\${list.map(live.show).join(', ')})\`));
                return [shown, printed, explained.status.value];
            })(${stdout})`);
            expect(shown.length > 1 && `${shown}` === `${printed}`, `${name}, pixel ${pixel}: shows ${shown}, the command prints ${printed}`);
            expect(/, as in the picture$/.test(status), `${name}, pixel ${pixel}: ${status}`);
            pixels += 1;
        }
    }
    return pixels;
}

// The page of a scene file: mistakes below their lines, and the scene in the link.
async function tryEditor() {
    await open('scene-editor.html');
    const write = (change) => chromium.value(`(() => {
        const { text } = live.editor;
        text.value = text.value.${change};
        text.oninput();
    })()`);
    await chromium.until(`live.editor.picture.controls`);
    await write(`replace('radius = 0.8', 'radios = 0.8')`);
    const line = await chromium.value(`live.editor.text.value.split('radios')[0].split('\\n').length`);
    await chromium.until(`live.editor.mistake.value === 'line ${line}: sphere has no "radios"; the nearest is radius'`);
    await shot('editor', `document.querySelector('.live-editor')`);
    // Between two mirrors each ray hits fifty surfaces, until the text is another.
    await write(`replace('depth = 4', 'depth = 50').replace('radios = 0.8', 'radius = 0.8').replace('[0.5, 0.55, 0.6]', '[1, 1, 1]') + '[[plane]]\\npoint = [0, 9, 0]\\nnormal = [0, -1, 0]\\nmaterial = "water"'`);
    await chromium.until(`location.hash.includes('depth%20%3D%2050')`);
    await write(`replace('depth = 50', 'depth = 2').replace('[640, 480]', '[64, 48]')`);
    await chromium.until(`/64 × 48/.test(live.editor.picture.status.value)`);
    const link = await chromium.value('location.href');
    await chromium.go('about:blank');
    await chromium.go(link);
    await chromium.until(`/64 × 48/.test(live.editor?.picture.status?.value)`);
    expect(/depth = 2/.test(await chromium.value('live.editor.text.value')), 'a link does not carry its scene');
    await chromium.until(`live.editor.drawn === live.editor.text.value && live.editor.picture.controls`);
    // What the pixel shows that the mouse is over, and every step of it.
    const met = await chromium.value(`live.editor.picture.probe(19, 23).then(() => live.editor.picture.probed.value)`);
    expect(/; object \d+: Sphere, at t = /.test(met), `the sphere's pixel is explained as ${met}`);
    const kinds = await chromium.value(`live.editor.picture.trace({ samples: 1, sampling: 0 }, [19, 23])
        .then(({ steps }) => steps.map(({ kind }) => kind))`);
    expect(['ray', 'test', 'hit', 'light'].every((kind) => kinds.includes(kind)), `the steps of a pixel are ${kinds}`);
    await tryNumbers();
}

// By the keyboard: the cursor in a line lights up its pixels, and a pixel has its lines, with a slider that
// changes the text and the picture.
async function tryNumbers() {
    await chromium.until(`live.editor.drawn === live.editor.text.value && live.editor.picture.controls`);
    // The line of the sphere's radius, from the one above.
    const line = await chromium.value(`(() => {
        const { text } = live.editor;
        const before = text.value.split('radius = 0.8')[0];
        text.focus();
        text.setSelectionRange(before.length - 1, before.length - 1);
        return before.split('\\n').length;
    })()`);
    await chromium.arrow('ArrowDown', 40);
    const said = 'live.editor.said.value';
    await chromium.until(`${said}.startsWith('Line ${line}, ')`);
    const sentence = await chromium.value(said);
    expect(/, radius of \[\[sphere\]\] #1: \d+ of 3,072 pixels change with it\. Most of all: column/.test(sentence), `the cursor says ${sentence}`);
    // The sphere is lit, and the sky is not.
    const [sphere, sky] = await chromium.value(`[[19, 23], [60, 2]].map((pixel) =>
        live.editor.dependents.canvas.getContext('2d').getImageData(...pixel, 1, 1).data[0])`);
    expect(sphere === 255 && sky === 0, `the sphere is lit ${sphere}, the sky ${sky}`);
    await shot('editor-line', `document.querySelector('.live-editor')`);
    await chromium.value(`live.editor.text.blur()`);
    expect(!(await chromium.value('live.editor.dependents.canvas.isConnected')), 'pixels stay lit without a cursor');

    await chromium.value(`live.editor.picture.frame.focus()`);
    await chromium.key('Enter');
    await chromium.until(`/^Pixel 32, 24: /.test(${said})`);
    await chromium.value(`live.editor.influences.open(19, 23)`);
    await chromium.until(`/^Pixel 19, 23: \\d+ of \\d+ numbers change it. The strongest is/.test(${said})`);
    const [marked, shown] = await chromium.value(`[document.querySelectorAll('.live-line').length, live.editor.influences.sliders.length]`);
    expect(marked > 3 && shown > 3, `a pixel has ${marked} lines and ${shown} sliders`);
    const all = await chromium.value(`live.editor.influences.strongest.map(({ index }) => live.editor.numbers.listed.numbers[index].table)`);
    expect(all.includes('[[sphere]] #1') && !all.includes('[[box]] #1'), `the sphere's pixel depends on ${all}`);
    await shot('editor-pixel', `document.querySelector('.live-editor')`);
    const words = 'live.editor.influences.list.textContent';
    expect(/[+-][\d.]+ ± \S+ per 1/.test(await chromium.value(words)), `no slope says how sure it is: ${await chromium.value(words)}`);
    // From the sphere's middle to the left, some pixel lies on an outline.
    const outline = await chromium.value(`(async () => {
        for (let column = 19; column >= 0; column -= 1) {
            await live.editor.influences.open(column, 23);
            const radius = [...live.editor.influences.list.children].find((item) => item.textContent.includes('radius'));
            if (radius?.textContent.includes('it jumps at')) {
                return column;
            }
        }
    })()`);
    expect(outline < 19, 'the radius lets no pixel jump on the way out of the sphere');
    await chromium.value(`live.editor.influences.open(19, 23)`);

    // The text counts as drawn before its picture is: so the picture is waited for, by its hash.
    const hash = 'live.editor.picture.hash';
    await chromium.until(hash);
    const before = await chromium.value(`[live.editor.text.value, ${hash}]`);
    await chromium.value(`live.editor.influences.list.querySelector('input[type=range]').focus()`);
    await chromium.arrow('ArrowRight', 39);
    await chromium.until(`live.editor.drawn !== ${JSON.stringify(before[0])} && live.editor.drawn === live.editor.text.value
        && location.hash.slice(7) === encodeURIComponent(live.editor.text.value)`);
    await chromium.until(`(${hash} ?? ${JSON.stringify(before[1])}) !== ${JSON.stringify(before[1])}`);
    await chromium.key('Escape');
    expect(!(await chromium.value(`document.querySelector('.live-influences, .live-line')`)), 'Escape does not close the numbers of a pixel');
    await chromium.click('live.editor.picture.canvas');
    await chromium.until(`/^Pixel \\d+, \\d+: \\d+ of/.test(${said})`);
}

// A button draws the picture of a further exercise by the reader's code, for which an answer of two
// black pixels stands.
async function tryYours() {
    await open('a01-exercises.html');
    await chromium.value(`live.yours = { 'a01-image-display': ['line'] };
        live.start = async () => async ({ request }) => (live.asked = request, { size: [2, 1], pixels: new Array(8).fill(0) });
        ${readFileSync(new URL('../page/yours.js', import.meta.url), 'utf8')}`);
    await chromium.click(`[...document.querySelectorAll('button')].find(({ textContent }) => textContent === 'draw it by your line.rs')`);
    await chromium.until(`document.querySelector('.live-yours output')?.value === 'Your line.rs draws this.'`);
    const drawn = await chromium.value(`live.asked + document.querySelector('.live-yours canvas').width`);
    expect(drawn === 'line a01-image-display-exercise-line2', `the button draws ${drawn}`);
}

// The pairs of a page: the slider shows more or less of the wrong picture. Returns their
// names.
async function tryPairs(page) {
    const pairs = await chromium.value(`live.pairs.map(({ image }) => /([^/]+)\\.png$/.exec(image.src)[1])`);
    for (const index of pairs.keys()) {
        const pair = `live.pairs[${index}]`;
        const seen = [];
        for (const value of [0, 50, 100]) {
            await chromium.value(`${pair}.image.decode().then(() => { ${pair}.slider.value = ${value}; ${pair}.slider.oninput(); })`);
            seen.push(await chromium.picture(`${pair}.canvas`));
        }
        expect(new Set(seen).size === 3, `${page}: pair ${index} does not answer its slider`);
    }
    return pairs;
}

// Tables, listings and formulas wider than the page scroll.
async function tryWidths(page, width) {
    const cut = await chromium.value(`(() => {
        const scrolls = (element) => element && element !== document.body
            && (/auto|scroll/.test(getComputedStyle(element).overflowX) || scrolls(element.parentElement));
        const wide = [...document.querySelectorAll('main :is(pre, code, table, .katex-display, img, figure, svg, canvas, select)')]
            .filter((element) => element.checkVisibility() && element.getBoundingClientRect().right > innerWidth + 1)
            .filter((element) => !element.closest('.img-wrapper') && !scrolls(element));
        return [document.documentElement.scrollWidth, ...wide.map((element) => element.outerHTML.slice(0, 90))];
    })()`);
    expect(cut[0] <= width, `${page} is ${cut[0]} pixels wide in a window of ${width}`);
    cut.slice(1).forEach((element) => expect(false, `${page}, cut at ${width} pixels: ${element}`));
}

// The tools of single pages: what is left out, extreme cases, and error against run time.
async function tryTools() {
    const programs = new URL('..', pathToFileURL(resolve(answers))).pathname;
    const tools = { chromium, expect, run, programs, shot };
    await open('left-out.html');
    await tryLeftOut(tools);
    await open('extreme-cases.html');
    await tryExtremes(tools);
    await tryOwnCurve(tools);
    const stage = new URL('../a03-rays-cameras', pathToFileURL(resolve(answers))).pathname;
    await tryMeasure({ chromium, expect, open, shot, run, stage });
}

// Five settings of a figure: as it opens, and spread over the ranges of its sliders.
const settings = (figure) => `(() => {
    const { state, sliders = {}, area } = ${figure}.figure;
    return [0, 1, 2, 3, 4].map((round) => {
        const entries = Object.entries(state).map(([name, value], index) => {
            const { min, max, step, choices } = sliders[name] ?? {};
            // A picture whose size is no matter of the numbers is small.
            if (name === 'coarse') return [name, 8];
            if (round === 0 || name === 'step') return [name, value];
            if (choices) return [name, round % choices.length];
            if (step) return [name, min + step * Math.floor(((max - min) / step) * ((round + 0.5) / 5))];
            return [name, value + 0.07 * round * (index % 2 ? 1 : -1)];
        });
        return Object.fromEntries(entries);
    });
})()`;

// Displayed values against those that the native library gives.
async function tryValues(name, figure) {
    const [states, request, count] = await chromium.value(`[${settings(figure)}, ${figure}.name, ${figure}.figure.numbers]`);
    const requests = states.map((state) => [request, ...Object.values(state).slice(0, count ?? undefined)].join(' '));
    const { stdout } = spawnSync(answers, { input: requests.join('\n'), encoding: 'utf8' });
    const given = stdout.trimEnd().split('\n').map((line) => Object.fromEntries(line.split(' ').map((list) => {
        const [list_name, numbers] = list.split('=');
        return [list_name, numbers ? numbers.replaceAll('inf', 'Infinity').split(',') : []];
    })));
    const rows = await chromium.value(`(async (states, given) => {
        const rows = [];
        for (const [index, state] of states.entries()) {
            await ${figure}.set(state);
            const values = ${figure}.values.map(([value, element]) => {
                const [list, at = 0] = value.split('.');
                const number = given[index][list]?.[at];
                return [value, element.value, live.show(number && Number(number))];
            });
            rows.push([${figure}.root.dataset.error ?? '', values]);
        }
        return rows;
    })(${JSON.stringify(states)}, ${JSON.stringify(given)})`);
    for (const [index, [error, values]] of rows.entries()) {
        expect(!error, `${name}: ${error}`);
        for (const [value, text, expected] of values) {
            expect(text === expected, `${requests[index]}: ${value} shows ${text}, the library says ${expected}`);
        }
    }
}

// A question hides the numbers until the reader has chosen an answer.
async function tryQuestion(name, figure) {
    const asked = () => chromium.value(`${figure}.root.dataset.asked !== undefined`);
    if (!(await asked())) {
        expect(await chromium.value(`${figure}.figure.grows`), `${name}: has no question before the answer`);
        return;
    }
    await chromium.click(`${figure}.root.querySelector('.live-question button')`);
    expect(!(await asked()), `${name}: an answer to its question does not show the numbers`);
    const verdict = await chromium.value(`${figure}.root.querySelector('.live-question output').value`);
    expect(/^(Yes|No): /.test(verdict), `${name}: an answer to its question gets no verdict`);
}

async function tryFigure(name) {
    const figure = `live.figures['${name}']`;
    await chromium.middle(`${figure}.root`);
    await chromium.until(`${figure}.root.dataset.drawn`);
    const state = () => chromium.value(`JSON.stringify(${figure}.state)`);
    // An answer that is still on its way moves handles when it comes.
    const settled = () => chromium.value(`${figure}.set({}).then(() => 0)`);
    await tryQuestion(name, figure);
    const handles = await chromium.value(`${figure}.handles?.length ?? 0`);
    for (let index = 0; index < handles; index += 1) {
        await settled();
        const circle = `${figure}.handles[${index}].circle`;
        const label = `${name}, ${await chromium.value(`${figure}.handles[${index}].label`)}`;
        const [x, y] = await chromium.middle(circle);
        expect(await chromium.value(`document.elementFromPoint(${x}, ${y}) === ${circle}`), `${label}: lies below something else`);
        let before = await state();
        await chromium.drag(circle, 12, -9);
        expect((await state()) !== before, `${label}: does not answer a drag`);
        before = await state();
        await chromium.value(`${circle}.focus()`);
        await chromium.key('ArrowRight');
        await chromium.key('ArrowUp');
        expect((await state()) !== before, `${label}: does not answer the keyboard`);
    }
    if (await chromium.value(`'yaw' in ${figure}.state`)) {
        const yaw = () => chromium.value(`${figure}.state.yaw`);
        const before = await yaw();
        // At a corner there is no handle.
        const [x, y] = await chromium.value(`(({ x, y }) => [x + 5, y + 5])(${figure}.svg.getBoundingClientRect())`);
        await chromium.swipe(x, y, 20, 10);
        const dragged = await yaw();
        expect(dragged !== before, `${name}: does not turn by a drag`);
        await chromium.value(`${figure}.svg.focus()`);
        await chromium.key('ArrowLeft');
        expect((await yaw()) > dragged, `${name}: does not turn by an arrow key`);
        expect(await chromium.value(`${figure}.together.every((other) => other.state.yaw === ${figure}.state.yaw)`), `${name}: turns alone`);
    }
    const sliders = await chromium.value(`[...${figure}.root.querySelectorAll('.live-controls input')].length`);
    if (sliders) {
        await settled();
        const slider = `${figure}.root.querySelector('.live-controls input')`;
        let before = await state();
        await chromium.drag(slider, 25, 0);
        expect((await state()) !== before, `${name}: its slider does not answer a drag`);
        before = await state();
        await chromium.value(`${slider}.focus()`);
        // At either end of the slider one of these moves it.
        await chromium.arrow('ArrowLeft', 37);
        await chromium.arrow('ArrowRight', 39);
        await chromium.arrow('ArrowRight', 39);
        expect((await state()) !== before, `${name}: its slider does not answer the keyboard`);
    }
    await tryValues(name, figure);
    await chromium.value(`${figure}.set(${figure}.figure.state).then(() => 0)`);
    await shot(`figure-${name}`, `${figure}.root`);
}

// A word points to lines of the listing and to parts of the figure, by mouse and keyboard.
async function tryWords() {
    await open('a04-intersections.html');
    const word = `live.words.find((word) => word.textContent === 'near')`;
    await chromium.middle(`live.figures.slabs.root`);
    await chromium.until(`live.figures.slabs.root.dataset.drawn`);
    const pointed = () => chromium.value(`[CSS.highlights.get('live-pointed')?.size ?? 0, [...document.querySelectorAll('.live-figure svg *')].filter((shape) => getComputedStyle(shape).strokeWidth === '6px').length]`);
    await chromium.mouse('mouseMoved', ...(await chromium.middle(word)));
    await chromium.until(`CSS.highlights.has('live-pointed')`);
    const byMouse = await pointed();
    expect(byMouse.every((count) => count >= 3), `the word near points to ${byMouse} lines and shapes`);
    await chromium.mouse('mouseMoved', 1, 1);
    await chromium.until(`!CSS.highlights.has('live-pointed')`);
    await chromium.value(`${word}.focus()`);
    expect(`${await pointed()}` === `${byMouse}`, 'a word points elsewhere by keyboard');
}

// The tests of some pages; returns what they have.
async function tryPages() {
    await chromium.open(1280, 900);
    if (workerData.part === 0) {
        await tryByHand();
        await tryWords();
    } else {
        await tryTools();
        await tryEditor();
        await tryYours();
    }

    const found = [];
    let locks = {};
    const figures = [];
    const pairs = [];
    let pixels = 0;
    const pages = [];
    for (const page of untested()) {
        pages.push(page);
        await open(page);
        await tryFormulas(page);
        // Each picture once, though other pages may show it, too.
        const shown = await chromium.value(`live.pictures.map(({ name }) => name)`);
        const names = [...new Set(shown)].filter((name) => firstPage(name) === page);
        await tryPictures(page, names);
        found.push(...names);
        pixels += await tryPixels(names);
        pairs.push(...(await tryPairs(page)));
        await tryWidths(page, 1280);
        locks = await chromium.value('live.locks');
        for (const name of await chromium.value('Object.keys(live.figures)')) {
            figures.push(name);
            await tryFigure(name);
        }
    }

    // A phone, in the dark.
    await chromium.resize(390, 844);
    await chromium.send('Emulation.setEmulatedMedia', { features: [{ name: 'prefers-color-scheme', value: 'dark' }] });
    for (const page of pages) {
        await open(page);
        await tryWidths(page, 390);
        // With its hint folded, a figure fits the screen.
        const high = await chromium.value(`[...document.querySelectorAll('main .live-figure')].map((figure) => {
            figure.querySelectorAll('details').forEach((fold) => (fold.open = false));
            return figure.offsetHeight;
        })`);
        expect(high.every((height) => height <= 844), `${page}: figures are ${high} pixels high on a phone`);
        for (const name of await chromium.value('Object.keys(live.figures)')) {
            const figure = `live.figures['${name}']`;
            await chromium.middle(`${figure}.root`);
            await chromium.until(`${figure}.root.dataset.drawn`);
            const box = await chromium.value(`${figure}.root.scrollWidth - ${figure}.root.clientWidth`);
            expect(box <= 0, `the figure ${name} is ${box} pixels too wide on a phone`);
            const handles = await chromium.value(`(${figure}.handles ?? []).map(({ circle }) => circle.getBoundingClientRect().width)`);
            expect(handles.every((handle) => handle >= 32), `the figure ${name} has handles of ${handles} pixels on a phone`);
            await shot(`phone-${name}`, `${figure}.root`);
        }
    }
    expect(await chromium.value(`getComputedStyle(document.documentElement).colorScheme === 'dark' || document.documentElement.classList.contains('coal')`), 'the book is not dark');

    // Without WebAssembly the pictures stand.
    await chromium.resize(1280, 900);
    await chromium.send('Page.addScriptToEvaluateOnNewDocument', { source: 'delete globalThis.WebAssembly' });
    for (const page of pages.filter((page) => texts.some(([name, text]) => name === page && text.includes('<img')))) {
        await open(page);
        const bad = await chromium.value(`[...document.querySelectorAll('main img[src$=".png"]:not(.img-wrapper > img)')].filter((image) => !image.complete || !image.naturalWidth || !image.checkVisibility()).length`);
        expect(bad === 0, `${page}: ${bad} pictures are missing without WebAssembly`);
        const traces = await chromium.value(`document.querySelectorAll('.live-picture, .live-figure').length`);
        expect(traces === 0, `${page} offers live pictures without WebAssembly`);
    }
    chromium.errors.forEach((error) => expect(false, `console: ${error}`));
    return { found, locks: Object.keys(locks), figures, pairs, pixels };
}

// What all pages together must have.
function checkTotals(parts) {
    const [found, locks, figures, pairs, pixels] = ['found', 'locks', 'figures', 'pairs', 'pixels'].map((name) => parts.flatMap((part) => part[name]));
    for (const name of locks) {
        expect(found.includes(name), `no page shows ${name} live`);
    }
    for (const name of locks.filter((name) => /^errata-|^go-wrong-cracks$/.test(name))) {
        expect(pairs.includes(name), `no page has a slider for the pair ${name}`);
    }
    console.log(`${new Set(found).size} live pictures have the locked bytes; ${pairs.length} pairs slide; ${figures.length} figures answer: ${figures.join(', ')}`);
    for (const [name, steps] of [['vectors', 5], ['camera', 6], ['scene', 16]]) {
        expect(figures.filter((figure) => figure.startsWith(`${name}-`)).length === steps, `a section of the figure ${name} has another heading`);
    }
    const explained = pixels.reduce((sum, count) => sum + count);
    expect(explained >= 50, `only ${explained} pixels were explained`);
    console.log(`${explained} explained pixels have the numbers of the command`);
}

// A thread of this file that tests its part of the pages; returns what they have.
function inThread(part) {
    return new Promise((resolve, reject) => {
        const worker = new Worker(new URL(import.meta.url), { argv: process.argv.slice(2), workerData: { part, taken: taken.buffer } });
        worker.on('message', resolve);
        worker.on('error', reject);
    });
}

if (isMainThread) {
    try {
        const parts = await Promise.all([...Array(browsers).keys()].map(inThread));
        complaints.push(...parts.flatMap((part) => part.complaints));
        checkTotals(parts);
    } catch (error) {
        expect(false, error.stack);
    }
    console.log(complaints.length ? `${complaints.length} complaints` : 'the book lives');
    process.exit(complaints.length ? 1 : 0);
} else {
    let totals = { found: [], locks: [], figures: [], pairs: [], pixels: 0 };
    try {
        totals = await tryPages();
    } catch (error) {
        expect(false, error.stack);
    } finally {
        await chromium.close();
    }
    parentPort.postMessage({ ...totals, complaints });
}
