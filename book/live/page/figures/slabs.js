// The slab test: a box is where its slabs overlap.
live.figure('slabs', {
    below: 'slab-test.svg',
    title: 'Drag the ray through the slabs',
    hint: 'Each slab is asked alone, as a box that is almost endless in the other directions; then the box itself. The third slab is parallel to the page.',
    question: {
        text: 'The ray enters one slab at t = 2 and leaves it at 5; it enters the other at 6 and leaves it at 9. Does it hit the box?',
        choices: ['yes', 'no'],
        right: 1,
        because: 'it leaves the first slab before it enters the second. It is never inside both: near = 6 is beyond far = 5.',
    },
    area: { x: [-3, 3], y: [-2, 2] },
    state: { ox: -2.6, oy: -1.4, x: 0.6, y: 0.2 },
    handles: [live.handle('origin of the ray', 'ox', 'oy'), live.handle('a point of the ray', 'x', 'y')],
    values: {
        'x_slab.0': 'x: enters at', 'x_slab.1': 'leaves at',
        'y_slab.0': 'y: enters at', 'y_slab.1': 'leaves at',
        hit: 'hit of the box at', 'normal.0': 'normal x', 'normal.1': 'normal y',
    },
    draw(pen, { ox, oy }, { direction: [dx, dy], x_slab, y_slab, both }) {
        const at = (t) => [ox + t * dx, oy + t * dy];
        pen.path([[-1, -2], [1, -2], [1, 2], [-1, 2]], 'a pale', true);
        pen.path([[-3, -0.7], [3, -0.7], [3, 0.7], [-3, 0.7]], 'c pale', true);
        pen.path([[-1, -0.7], [1, -0.7], [1, 0.7], [-1, 0.7]], 'ink', true);
        pen.arrow([ox, oy], at(8), 'ink');
        if (both.length === 2) {
            pen.line(at(both[0]), at(both[1]), 'b wide');
        }
        x_slab.forEach((t) => pen.dot(at(t), 'a'));
        y_slab.forEach((t) => pen.dot(at(t), 'c'));
        pen.text([-0.95, 1.6], 'slab in x', 'a');
        pen.text([-2.95, 0.42], 'slab in y', 'c');
        pen.text([ox, oy], 'o');
    },
});
