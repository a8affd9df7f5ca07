// Two vectors: their products and angle, a projection and a reflection.
live.figure('vectors', {
    below: 'dot-product.svg',
    title: 'Drag the vectors',
    hint: 'The wide line is the projection of a on b, the dashed arrow r the reflection of a on a surface with the normal b, and the pale area |a × b|.',
    question: {
        text: 'The vector a turns until it points away from b, by more than a right angle. The dot product is then…',
        choices: ['positive', 'zero', 'negative'],
        right: 2,
        because: 'the cosine of an angle above 90 degrees is negative. The projection lies behind the start of b.',
    },
    area: { x: [-2.6, 2.6], y: [-1.6, 1.7] },
    state: { ax: 0.7, ay: 1.2, bx: 1.7, by: 0.2 },
    handles: [live.handle('the vector a', 'ax', 'ay'), live.handle('the vector b', 'bx', 'by')],
    values: { dot: 'a · b', area: '|a × b|', angle: 'angle in degrees', cosine: 'its cosine', 'projection.0': 'projection: x', 'projection.1': 'y', 'reflected.0': 'reflection: x', 'reflected.1': 'y' },
    draw(pen, { ax, ay, bx, by }, { projection, reflected }) {
        const [o, a, b] = [[0, 0], [ax, ay], [bx, by]];
        pen.path([o, a, [ax + bx, ay + by], b], 'c pale', true);
        if (projection.length) {
            pen.line(o, projection, 'c wide');
            pen.line(a, projection, 'thin');
            pen.arrow(o, reflected, 'thin');
            pen.text(reflected, 'r');
        }
        pen.arrow(o, a, 'a');
        pen.arrow(o, b, 'b');
        pen.text(a, 'a', 'a');
        pen.text(b, 'b', 'b');
    },
});
