// The order of a chain: rotated and moved, or moved and rotated.
live.figure('chain', {
    below: 'chain-order.svg',
    title: 'The order of a chain',
    hint: 'Both flags get the same rotation and the same translation. Calls of Transform read from the outside inwards: translate(…).rotate_z(…) rotates first.',
    question: {
        text: 'A flag at the origin is moved to the right and then rotated by 90 degrees about the origin. It stands…',
        choices: ['on the right', 'above the origin'],
        right: 1,
        because: 'the rotation takes the moved flag along, on a circle around the origin.',
    },
    area: { x: [-3.2, 3.2], y: [-1.8, 3] },
    state: { angle: 60, x: 1.6, y: 0 },
    sliders: { angle: { label: 'angle in degrees', min: -180, max: 180, step: 5 } },
    handles: [live.handle('the translation', 'x', 'y')],
    values: {
        'turned_first.4': 'tip, rotated first: x', 'turned_first.5': 'y',
        'moved_first.4': 'tip, moved first: x', 'moved_first.5': 'y',
    },
    draw(pen, _, { turned_first, moved_first }) {
        const points = (list) => list.reduce((all, x, i) => (i % 2 ? all : [...all, [x, list[i + 1]]]), []);
        pen.line([-3.2, 0], [3.2, 0], 'thin');
        pen.line([0, -1.8], [0, 3], 'thin');
        pen.path(points(turned_first), 'a pale', true);
        pen.path(points(moved_first), 'b pale', true);
        pen.text(turned_first.slice(4), 'rotated, then moved', 'a', 'middle');
        pen.text(moved_first.slice(4), 'moved, then rotated', 'b', 'middle');
    },
});
