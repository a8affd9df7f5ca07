// The slab test: a box is where its three slabs overlap.
live.figure('slabs', {
    below: 'slab-test.svg',
    title: 'Drag the ray through the slabs',
    hint: 'Above, the box from the front; z points towards you. Below, each bar reaches from the t at which the ray enters a slab to the t at which it leaves it. The ray is in the box where all three bars overlap.',
    question: {
        text: 'The ray enters one slab at t = 2 and leaves it at 5; it enters another at 6 and leaves it at 9. Does it hit the box?',
        choices: ['yes', 'no'],
        right: 1,
        because: 'it leaves the first slab before it enters the second. It is never inside both: near = 6 is beyond far = 5.',
    },
    area: { x: [-4, 4], y: [-3.9, 1.6] },
    state: { ox: -2.6, oy: -1.4, x: 0.6, y: 0.2, oz: 2, z: 0 },
    sliders: {
        oz: { label: 'z of the origin', min: -3, max: 3, step: 0.1 },
        z: { label: 'z of the point', min: -3, max: 3, step: 0.1 },
    },
    handles: [live.handle('origin of the ray', 'ox', 'oy'), live.handle('a point of the ray', 'x', 'y')],
    values: {
        'x_slab.0': 'x: enters at', 'x_slab.1': 'leaves at',
        'y_slab.0': 'y: enters at', 'y_slab.1': 'leaves at',
        'z_slab.0': 'z: enters at', 'z_slab.1': 'leaves at',
        hit: 'hit of the box at', 'normal.0': 'normal x', 'normal.1': 'y', 'normal.2': 'z',
    },
    draw(pen, { ox, oy }, { direction: [dx, dy], x_slab, y_slab, z_slab, both }) {
        const at = (t) => [ox + t * dx, oy + t * dy];
        pen.path([[-1, -2], [1, -2], [1, 2], [-1, 2]], 'a pale', true);
        pen.path([[-4, -0.7], [4, -0.7], [4, 0.7], [-4, 0.7]], 'c pale', true);
        pen.path([[-1, -0.7], [1, -0.7], [1, 0.7], [-1, 0.7]], 'ink', true);
        pen.arrow([ox, oy], at(9), 'ink');
        if (both.length) {
            pen.line(at(both[0]), at(both[1]), 'b wide');
        }
        x_slab.forEach((t) => pen.dot(at(t), 'a'));
        y_slab.forEach((t) => pen.dot(at(t), 'c'));
        pen.text([-0.95, 1.05], 'slab in x', 'a');
        pen.text([-3.95, 0.1], 'slab in y', 'c');
        pen.text([ox, oy], 'o');

        // White paper below the bars hides the ends of slabs and ray.
        pen.shapes.push(`<rect class="live-paper" x="0" y="${pen.to([0, -2.05])[1]}" width="${live.Pen.width}" height="${pen.height}"/>`);
        const along = (t) => -2.3 + 0.52 * Math.min(Math.max(t, -0.6), 9.6);
        [['x', x_slab, 'a'], ['y', y_slab, 'c'], ['z', z_slab, 'ink']].forEach(([name, slab, kind], row) => {
            const y = -2.45 - 0.4 * row;
            pen.text([-2.95, y - 0.22], name, kind);
            if (slab.length) {
                pen.line([along(slab[0]), y], [along(slab[1]), y], `${kind} wide part-near_axis part-far_axis`);
            }
        });
        pen.line([along(0), -3.5], [along(9.6), -3.5], 'ink');
        [0, 2, 4, 6, 8].forEach((t) => {
            pen.line([along(t), -3.5], [along(t), -3.58], 'ink');
            pen.text([along(t), -3.95], `${t}`, '', 'middle');
        });
        pen.text([along(9.2), -3.95], 't', '', 'middle');
        both.forEach((t, i) => {
            const name = ['near', 'far'][i];
            pen.line([along(t), -2.2], [along(t), -3.5], `b thin part-${name}`);
            pen.dot(at(t), `b part-${name}`);
            pen.text([along(t), -2.4], name, `b part-${name}`, 'middle');
        });
    },
});
