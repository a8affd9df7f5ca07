// The fractions of a triangle's corners, and the normal that they mix.
live.figure('barycentric', {
    below: 'barycentric.svg',
    title: 'Drag the point and the corners',
    hint: 'Triangle::hit mixes the normals of the corners by these fractions; the arrow is the mixed normal, seen from above. The normals of the corners lean outwards.',
    question: {
        text: 'The point lies in the middle of the edge from a to b. The fraction of c is…',
        choices: ['1/3', '0', '1/2'],
        right: 1,
        because: 'the part of the triangle opposite of c has no area there.',
    },
    area: { x: [-2, 2], y: [-1.4, 1.4] },
    state: { ax: -1.4, ay: -0.9, bx: 1.4, by: -0.7, cx: 0.1, cy: 1.1, x: 0.5, y: -0.4 },
    handles: [
        live.handle('corner a', 'ax', 'ay'),
        live.handle('corner b', 'bx', 'by'),
        live.handle('corner c', 'cx', 'cy'),
        live.handle('the point', 'x', 'y'),
    ],
    values: {
        'weights.0': 'α, of a', 'weights.1': 'β, of b', 'weights.2': 'γ, of c',
        'normal.0': 'normal x', 'normal.1': 'y', 'normal.2': 'z',
    },
    draw(pen, { ax, ay, bx, by, cx, cy, x, y }, { normal, weights }) {
        const [a, b, c, p] = [[ax, ay], [bx, by], [cx, cy], [x, y]];
        pen.path([p, b, c], 'a pale', true);
        pen.path([a, p, c], 'b pale', true);
        pen.path([a, b, p], 'c pale', true);
        [[a, 'a'], [b, 'b'], [c, 'c']].forEach(([[x, y], name]) => pen.text([1.18 * x, 1.18 * y - 0.13], name, name, 'middle'));
        if (weights.length) {
            pen.arrow(p, [x + normal[0], y + normal[1]], 'ink');
        } else {
            pen.text(p, 'outside');
        }
    },
});
