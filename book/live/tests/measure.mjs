// Error against run time in the browser, by keyboard alone: guessed, measured, stopped and measured again. Errors,
// their intervals and the work are those that the reports of stage 3 write into their CSV files.
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const settings = [
    ['samples-curved-edge', ['samples-curved-edge']],
    ['samples-level-edge', ['samples-level-edge']],
    ['a03-rays-cameras-striped-sky', ['scene', 'striped-sky']],
];

// The rows that a report writes, by method and parameter.
async function reported(run, stage, names) {
    const folder = mkdtempSync(join(tmpdir(), 'report-'));
    await run(stage, ['report', ...names, '--output', folder]);
    const rows = {};
    for (const line of readFileSync(join(folder, `a03-rays-cameras-${names.at(-1)}.csv`), 'utf8').split('\n')) {
        const [, method, place, , numbers] = line.split('"');
        if (method) {
            const [, parameter, work] = place.split(',');
            const [, error, low, high] = numbers.split(',').map(Number);
            rows[`${method} ${parameter}`] = { work: Number(work), error, low, high };
        }
    }
    rmSync(folder, { recursive: true });
    return rows;
}

export async function tryMeasure({ chromium, expect, open, shot, run, stage }) {
    const page = 'error-and-run-time.html';
    await open(page);
    const figure = 'live.measure';
    const value = (words) => chromium.value(`${figure}.${words}`);
    const press = (element) => chromium.enter(`${figure}.${element}`);
    const curves = () => value(`root.querySelectorAll('.recorded').length`);
    expect((await curves()) === 0, `${page}: recorded curves answer before the guess`);
    await shot('measure-before', `${figure}.root`);
    await press('run.start');
    await chromium.until(`/^Guess first/.test(${figure}.run.status.value)`);
    await press(`question.querySelector('button')`);
    expect(await value(`question.contains(document.activeElement)`), `${page}: an answer loses the focus`);
    expect((await curves()) === 4, `${page}: no recorded curves after the guess`);
    await shot('measure-recorded', `${figure}.root`);
    for (const [subject, names] of settings) {
        await value(`subject.value = '${subject}'; ${figure}.choose()`);
        await press(`question.querySelector('button')`);
        await press('run.start');
        // Stopped at once, and started again.
        await chromium.until(`!${figure}.run.halt.disabled`);
        await press('run.halt');
        await chromium.until(`${figure}.run.halt.disabled && ${figure}.run.status.value === 'stopped'`);
        await press('run.start');
        await chromium.until(`${figure}.run.rounds > 0`);
        await press('run.halt');
        await chromium.until(`${figure}.run.halt.disabled`);
        // It goes on where it was.
        const rounds = await value('run.rounds');
        expect((await value('run.start.textContent')) === 'go on', `${subject}: nothing goes on after a stop`);
        await press('run.start');
        await chromium.until(`${figure}.run.rounds > ${rounds} || ${figure}.run.status.value.endsWith('rounds measured')`);
        await press('run.halt');
        await chromium.until(`${figure}.run.halt.disabled`);
        const rows = await reported(run, stage, names);
        const points = await value('points');
        const compared = points.filter(({ method }) => method !== 'one in the middle');
        expect(compared.length === Object.keys(rows).length, `${subject}: measures ${compared.length} points`);
        for (const { method, parameter, work, error, error_low, error_high } of compared) {
            const row = rows[`${method} ${parameter}`];
            const [low, high] = [error_low, error_high].map((end) => Number(end.toExponential(3)));
            expect(row && work === row.work && error === row.error && low === row.low && high === row.high,
                `${subject}, ${method} at ${parameter}: ${[work, error, low, high]}, the report says ${JSON.stringify(row)}`);
        }
        const middle = points.find(({ method }) => method === 'one in the middle');
        expect(middle.error === rows['regular 1'].error, `${subject}: one sample in the middle errs by ${middle.error}`);
        expect(points.every(({ seconds, seconds_low, seconds_high }) => seconds_low <= seconds && seconds <= seconds_high && seconds > 0), `${subject}: times lie outside of their intervals`);
        // The line, and a point with its picture.
        const verdict = () => value('verdict.textContent');
        await chromium.until(`/^An error of 0/.test(${figure}.verdict.textContent)`);
        // The program takes the sample counts that the page names.
        for (const [, method, count] of (await verdict()).matchAll(/(regular|stratified|random): (\S+) samples? per pixel/g)) {
            const cells = method === 'random' ? Number(count) : Math.sqrt(count);
            expect(Number.isInteger(cells), `${subject}: ${method} takes no ${count} samples`);
        }
        const before = await verdict();
        await value('diagram.handle.focus()');
        await chromium.key('ArrowUp');
        await chromium.until(`${figure}.verdict.textContent !== ${JSON.stringify(before)}`);
        const dragged = await value('diagram.wanted');
        await chromium.drag(`${figure}.diagram.handle`, 0, -30);
        expect((await value('diagram.wanted')) > dragged, `${subject}: the line does not answer a drag`);
        expect(/samples? per pixel, .* rounds?: an interval of 95 % takes six/.test(await verdict()), `${subject}: says ${await verdict()}`);
        expect(!(await value(`verdict.querySelector('strong')`)), `${subject}: a verdict of less than six rounds is bold`);
        // At its lowest the handle covers no words of the axes.
        const covered = await value(`diagram.svg.querySelectorAll('text.axis').values().filter((words) => {
            ${figure}.diagram.want(-99);
            const [a, b] = [words, ${figure}.diagram.handle].map((shape) => shape.getBoundingClientRect());
            return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
        }).map(({ textContent }) => textContent).toArray()`);
        expect(!covered.length, `${subject}: the handle covers ${covered}`);
        await value(`diagram.points.querySelector('[tabindex="0"]').focus()`);
        await chromium.key('ArrowRight');
        await chromium.until(`!${figure}.shown.hidden && ${figure}.caption.textContent.startsWith(document.activeElement.getAttribute('aria-label'))`);
    }
    await shot('measure', `${figure}.root`);

    // A scene of the editor's, whose link does not break off a measurement of another.
    await chromium.value(`location.hash = '#scene=' + encodeURIComponent('[camera]\\neye = [0, 0, 5]\\n[[light]]\\nkind = "sun"')`);
    await chromium.until(`${figure}.subject.value === 'file'`);
    await press(`question.querySelector('button')`);
    await press('run.start');
    await chromium.until(`${figure}.run.halt.disabled && ${figure}.run.status.value`);
    expect(/^\d+:\d+: /.test(await value('run.status.value')), `a wrong scene is answered by ${await value('run.status.value')}`);
    await chromium.resize(390, 844);
    await open(page);
    const wide = await value('root.scrollWidth - ' + `${figure}.root.clientWidth`);
    expect(wide <= 0, `${page}: the figure is ${wide} pixels too wide on a phone`);
    await shot('measure-phone', `${figure}.root`);
    await chromium.resize(1280, 900);
}
