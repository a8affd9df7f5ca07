// A ray between two mirrors and a mirroring ball, bounce by bounce.
live.figure('mirrors', {
    below: 'reflection.svg',
    title: 'Follow a ray, bounce by bounce',
    hint: 'World::hit, reflected_on and secondary_ray, in the order of the tracer’s loop. The light that a surface adds to the pixel is multiplied by the shares of all mirrors before it.',
    question: {
        text: 'Each mirror reflects one half. After how many surfaces is a white lamp at the end below one step of a byte, 1/255?',
        choices: ['3', '8', '255'],
        right: 1,
        because: 'one half to the 8th is 1/256. The depth of 6, which the scenes have, leaves 1/64.',
    },
    area: { x: [-2.2, 2.2], y: [-1.7, 1.7] },
    state: { x: -1.5, y: -1.2, angle: 0.8, depth: 6, share: 0.5 },
    sliders: {
        depth: { label: 'surfaces', min: 0, max: 12, step: 1 },
        share: { label: 'share that a mirror reflects', min: 0, max: 1, step: 0.05 },
    },
    handles: [
        live.handle('origin of the ray', 'x', 'y'),
        live.angleHandle('direction of the ray', 'angle', 0.7, ({ x, y }) => [x, y]),
    ],
    values: { hits: 'surfaces hit', left: 'share left after them' },
    draw(pen, { x, y }, { path, shares }) {
        [-2, 2].forEach((x) => pen.line([x, -1.7], [x, 1.7], 'a wide'));
        pen.circle([0, 0], 0.6, 'a pale');
        const at = (i) => [path[2 * i], path[2 * i + 1]];
        for (let i = 1; i < path.length / 2; i += 1) {
            pen.arrow(at(i - 1), at(i), i === 1 ? 'ink' : 'b');
            if (i <= shares.length) {
                pen.text(at(i), live.show(Number(shares[i - 1].toPrecision(2))), 'b', at(i)[0] > 1 ? 'end' : 'start');
            }
        }
        pen.text([x, y], 'o');
    },
});
