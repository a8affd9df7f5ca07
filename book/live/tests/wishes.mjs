// The figures of extreme cases and of what is left out, in the browser, against the programs.
import { writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

// Cases of `extremes` that are points of a problem, with their powers of ten. The rays of cases are along an axis, that
// of the far ball is not.
const CASES = {
    distance: { stage: 'a04' },
    tangent: { stage: 'a04', A43: -4, A44: -8, A21: -16 },
    needle: { stage: 'a04', D30: 2, D31: 5, D08: 8 },
    angle: { stage: 'a02', F40: -4, F03: -8, F04: -12 },
    matrix: { stage: 'a07', G33: 4, G05: 8, G06: 12 },
    spot: { stage: 'a05', F41: -1, F42: -4, F43: -6 },
    direction: { stage: 'a04', A23: -200, A27: 4, A30: 200 },
};

// What a program prints; `programs` is the folder that has it.
export const printed = async (run, programs, program, args) => (await run(`${programs}/${program}`, args, { cwd: tmpdir() })).stdout;

// Each problem: asked first, turned by the keyboard, and at three powers with the numbers of the program.
export async function tryExtremes({ chromium, expect, run, programs, shot }) {
    const figure = 'live.extremes';
    await chromium.middle(`${figure}.root`);
    await chromium.until(`${figure}.root.dataset.drawn !== undefined`);
    const names = await chromium.value(`${figure}.problems.map(({ name }) => name)`);
    expect(`${names}` === `${Object.keys(CASES)}`, `the problems are ${names}`);
    for (const [index, [name, { stage, ...cases }]] of Object.entries(CASES).entries()) {
        await chromium.value(`(${figure}.problem.value = ${index}, ${figure}.choose())`);
        const curves = () => chromium.value(`${figure}.drawing.svg.querySelectorAll('path.b').length`);
        expect((await curves()) === 0, `${name}: the answer is there before the guess`);
        const place = () => chromium.value(`${figure}.knob.value`);
        const before = await place();
        await chromium.value(`${figure}.knob.focus()`);
        await chromium.arrow('ArrowLeft', 37);
        await chromium.arrow('ArrowRight', 39);
        await chromium.arrow('ArrowRight', 39);
        expect((await place()) !== before, `${name}: the knob does not answer the keyboard`);
        // Every other one is answered by "it never breaks", of which none is so.
        await chromium.click(`${figure}.question.querySelectorAll('button')[${index % 2}]`);
        await chromium.until(`!('asked' in ${figure}.root.dataset)`);
        expect((await curves()) === 1, `${name}: no curve after the guess`);
        const verdict = await chromium.value(`${figure}.question.querySelector('output').value`);
        const said = index % 2 ? /^No: at 10 to the -?[\d.]+,/ : /^(Yes, nearly|No): at 10 to the -?[\d.]+,/;
        expect(said.test(verdict) && /There it (is off by|finds)/.test(verdict), `${name}: the verdict is ${verdict}`);
        const rows = await printed(run, programs, `${stage}-lab`, ['extremes', ...Object.keys(cases)]);
        for (const [id, power] of Object.entries(cases)) {
            const row = rows.slice(rows.indexOf(`${id}  `)).split('\n').slice(1, 4);
            const [exact, theirs, ours] = row.map((line) => line.slice(15).split('   ')[0]);
            const shown = await chromium.value(`${figure}.turn(${figure}.errors.powers.indexOf(${power}))
                .then(() => [...${figure}.digits.querySelectorAll('code')].map((code) => code.textContent))`);
            expect(Number(shown[0]) === Number(exact) && shown[1] === theirs && shown[2] === ours, `${name}, ${id}: shows ${shown}, the program prints ${exact}, ${theirs}, ${ours}`);
        }
        await shot(`extremes-${name}`, `${figure}.root`);
    }
}

// The reader's own formula as a third curve: the module of the exercises answers with what the protocol finds.
export async function tryOwnCurve({ chromium, expect }) {
    const errors = await chromium.value(`(async () => {
        const { start, yours } = live;
        live.yours = { 'a02-math': ['angle'] };
        live.start = async () => Object.assign(async ({ request, numbers: [count, ...given] }) =>
            (live.asked = request, { answers: given.filter((_, index) => index % count === 4).map(() => 0) }), { stop: () => {} });
        live.extremes.problem.value = 3;
        await live.extremes.choose();
        Object.assign(live, { start, yours });
        return [live.asked, live.extremes.drawing.svg.textContent.includes('yours'), [...live.extremes.errors.yours].every((error) => error > 1e15)];
    })()`);
    expect(errors[0] === 'angle answers ' && errors[1] && errors[2], `the own formula is shown as ${errors}`);
}

// Each scene: guessed first; with all switches on, with one after the other off, and with all off.
export async function tryLeftOut({ chromium, expect, run, programs, shot }) {
    const figure = 'live.leftOut';
    await chromium.middle(`${figure}.root`);
    await chromium.until(`${figure}.root.dataset.drawn !== undefined`);
    const scenes = await chromium.value(`[...${figure}.scene.options].map(({ value }) => value)`);
    for (const engine of [false, true]) {
        for (const scene of scenes) {
            const stage = ['a05-lighting', 'a06-shadows-reflection', 'a07-transforms'].find((stage) => scene.startsWith(`${stage}-`));
            const program = stage ?? 'a07-transforms';
            const name = stage ? scene.slice(stage.length + 1) : join(tmpdir(), 'balls.toml');
            if (!stage) {
                writeFileSync(name, scene.slice('file\n'.length));
            }
            const text = await printed(run, programs, program, ['render', name, '--explain', ...(engine ? ['--fast'] : [])]);
            const table = Object.fromEntries([...text.matchAll(/^ {2}([a-z]+ [a-z]+|powers) +(\d+) +(\d+)$/gm)].map(([, kind, all, done]) => [kind, { all: Number(all), done: Number(done) }]));
            const saved = Object.fromEntries([...text.matchAll(/^ {4}(\S[^:\n]*): (\d.+)$/gm)].map(([, words, counts]) =>
                [words, Object.fromEntries(counts.split(', ').map((count) => [count.replace(/^\d+ /, ''), parseInt(count)]))]));
            await chromium.value(`(${figure}.scene.value = ${JSON.stringify(scene)}, ${figure}.engine.checked = ${engine}, ${figure}.open())`);
            await chromium.click(`${figure}.question.querySelector('button')`);
            expect(/^(Yes|No): .*(saves|needs all)/.test(await chromium.value(`${figure}.question.querySelector('output').value`)), `${scene}: no verdict`);
            // With this many switches off, from the first: the program puts its omissions back in this order.
            const counts = async (off) => {
                const [shown, bytes] = await chromium.value(`(async () => {
                    ${figure}.omissions.forEach(({ box }, index) => (box.checked = index >= ${off}));
                    await ${figure}.update();
                    return [Object.fromEntries(${figure}.kinds.map((kind, index) => [kind, ${figure}.latest[index]])), ${figure}.bytes.value];
                })()`);
                expect(/^All \d+ bytes are the same/.test(bytes), `${scene}, ${off} switches off: ${bytes}`);
                return shown;
            };
            const here = `${scene}${engine ? ' by the engine' : ''}`;
            const omissions = await chromium.value(`${figure}.omissions.map(({ words }) => words)`);
            let before = await counts(0);
            for (const [kind, { done }] of Object.entries(table)) {
                expect(before[kind] === done, `${here}: ${before[kind]} ${kind}, the program has ${done}`);
            }
            for (const [index, words] of omissions.entries()) {
                const now = await counts(index + 1);
                for (const kind of Object.keys(table)) {
                    const [more, printed] = [Math.max(0, now[kind] - before[kind]), saved[words]?.[kind] ?? 0];
                    expect(more === printed, `${here}, ${words}: ${more} ${kind}, the program says ${printed}`);
                }
                before = now;
            }
            // The engine's own tests of all objects are counted in fours.
            for (const [kind, { all }] of Object.entries(engine ? {} : table)) {
                expect(before[kind] === all, `${here}, all off: ${before[kind]} ${kind}, the program has ${all}`);
            }
            // With all switches off, "yours" is "all work", and what the switches save is what lies between.
            const [shown, sums] = await chromium.value(`(({ kinds, omissions, work }) => [
                Object.fromEntries(kinds.map((kind, index) => [kind, work.all[index]])),
                omissions.map(({ words, saved }) => [words, Object.fromEntries(kinds.map((kind, index) => [kind, saved[index]]))]),
            ])(${figure})`);
            expect(JSON.stringify(shown) === JSON.stringify(before), `${here}: all work is ${JSON.stringify(shown)}, and all off ${JSON.stringify(before)}`);
            for (const [words, counts] of sums) {
                for (const kind of Object.keys(table)) {
                    expect(counts[kind] === (saved[words]?.[kind] ?? 0), `${here}, ${words}: saves ${counts[kind]} ${kind}, the program says ${saved[words]?.[kind]}`);
                }
            }
            await shot(`left-out-${stage ? name : 'balls'}${engine ? '-engine' : ''}`, `${figure}.root`);
        }
    }
    // Two switches save the same: both answers are right, and a third is wrong.
    const tied = ['shadow rays to a light that casts no shadows', 'reflected rays from surfaces that mirror nothing'];
    for (const words of [...tied, 'powers of highlights that nobody sees']) {
        const [answer, numbers] = await chromium.value(`(async () => {
            const figure = ${figure};
            figure.questions = {};
            [figure.scene.value, figure.engine.checked] = ['a07-transforms-box-transformations', false];
            await figure.open();
            const index = (words) => figure.omissions.findIndex((omission) => omission.words === words);
            figure.question.querySelectorAll('button')[index(${JSON.stringify(words)})].click();
            return [figure.question.querySelector('output').value, ${JSON.stringify(tied)}.map((words) => index(words) + 1)];
        })()`);
        const right = `${tied.includes(words) ? 'Yes' : 'No'}: ${numbers[0]} saves `;
        expect(answer.startsWith(right) && answer.includes(`, and ${numbers[1]} saves `), `a tie, answered ${words}: ${answer}`);
    }
    // A tree pays where there are many objects, as the page says.
    const tests = await chromium.value(`(async () => {
        const figure = ${figure};
        const at = figure.kinds.indexOf('intersection tests');
        const counts = async (scene, engine) => {
            [figure.scene.value, figure.engine.checked] = [scene, engine];
            await figure.open();
            return figure.latest[at];
        };
        const balls = [...figure.scene.options].at(-1).value;
        return [await counts(balls, false), await counts(balls, true)];
    })()`);
    expect(tests[1] < tests[0] / 3, `a hundred balls take ${tests} tests by lesson and engine`);
    // A scene of the editor, in the link from there.
    const [page, scene] = await chromium.value(`live.ask('export a05-lighting-phong').then(({ text }) => [location.href, text])`);
    await chromium.go('about:blank');
    await chromium.go(`${page}#scene=${encodeURIComponent(scene)}`);
    await chromium.middle(`${figure}.root`);
    await chromium.until(`${figure}.root.dataset.drawn !== undefined`);
    const own = await chromium.value(`[${figure}.scene.selectedOptions[0].textContent, ${figure}.latest[5], ${figure}.bytes.value.slice(0, 3)]`);
    expect(`${own}` === 'the scene of the editor,1879,All', `a scene of the editor has ${own}`);
    // Timed, stopped, and timed again, by the keyboard.
    await chromium.enter(`${figure}.run.start`);
    await chromium.until(`!${figure}.run.halt.disabled`);
    await chromium.enter(`${figure}.run.halt`);
    await chromium.until(`${figure}.run.status.value === 'stopped' && ${figure}.run.halt.disabled`);
    await chromium.enter(`${figure}.run.start`);
    await chromium.until(`/^Beside the picture/.test(${figure}.run.status.value)`);
    console.log(await chromium.value(`${figure}.run.status.value`));
}
