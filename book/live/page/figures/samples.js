// Samples in a pixel that an edge crosses, and how their error falls.
{
    const curves = {};
    // Rows count downwards, the drawing upwards.
    const normal = ({ angle }) => [Math.cos((angle * Math.PI) / 180), -Math.sin((angle * Math.PI) / 180)];
    const foot = (state) => normal(state).map((x) => 0.5 + state.offset * x);

    live.figure('samples', {
        below: 'pixel-samples.svg',
        title: 'How much of the pixel is covered?',
        hint: 'Left: a pixel and an edge; drag the edge. Right: the error over 400 pixels, on logarithmic axes, for 1 to 1024 samples; the thin lines fall as n to the -1/2 and n to the -3/4, the slopes that theory gives for random and for stratified places.',
        question: {
            text: 'Four times as many random samples. The error becomes…',
            choices: ['a quarter', 'half', 'almost the same'],
            right: 1,
            because: 'the error of a mean of n independent samples falls with the root of n. On a grid of cells, only the cells at the edge err, so it falls faster: by n to the -3/4.',
        },
        area: { x: [-0.1, 2.4], y: [-0.18, 1.22] },
        state: { angle: 20, offset: 0.1, samples: 16, sampling: 2, seed: 0 },
        sliders: {
            samples: { label: 'samples', min: 1, max: 256, step: 1 },
            sampling: { label: 'their places', choices: ['one in the middle', 'a regular grid', 'random', 'a stratified grid'] },
            seed: { label: 'seed', min: 0, max: 20, step: 1 },
        },
        handles: [live.follow('the edge', foot, { angle: [-Infinity, Infinity], offset: [-0.7, 0.7] })],
        values: { samples: 'samples', estimate: 'estimated', area: 'exact', error: 'error' },
        more: async ({ sampling }) => (curves[sampling] ??= await live.ask('sample-errors', [sampling])),
        draw(pen, state, { x, y, counts, errors }) {
            const [[nx, ny], [fx, fy]] = [normal(state), foot(state)];
            const covers = (x, y) => (x - 0.5) * nx + (1 - y - 0.5) * ny < state.offset;
            pen.path([[0, 0], [1, 0], [1, 1], [0, 1]], 'ink', true);
            const along = (t) => [fx - ny * t, fy + nx * t];
            pen.line(along(-0.6), along(0.6), 'b');
            x.forEach((x, i) => pen.dot([x, 1 - y[i]], covers(x, y[i]) ? 'a' : 'none', x.length > 64 ? 1.5 : 3));
            const log = (n, error) => [1.35 + Math.log10(n) / 3.1, 1 + Math.log10(error) / 4];
            pen.line([1.35, 0], [2.4, 0], 'ink');
            pen.line([1.35, 0], [1.35, 1.05], 'ink');
            for (const slope of [-0.5, -0.75]) {
                pen.line(log(1, errors[0]), log(1024, errors[0] * 1024 ** slope), 'thin');
            }
            pen.path(counts.map((n, i) => log(n, Math.max(errors[i], 1e-4))), 'c');
            counts.forEach((n, i) => pen.dot(log(n, Math.max(errors[i], 1e-4)), 'c'));
            pen.text([1.35, -0.18], '1 sample');
            pen.text([2.4, -0.18], '1024', '', 'end');
            pen.text([1.37, 1.02], 'error');
        },
    });
}
