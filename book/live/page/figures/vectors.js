// Two vectors on a table, which gain their products, their angle, a projection and a
// reflection.
{
    // The plane of both vectors lies level, and their cross product stands on it.
    const flat = (state, x, y, z = 0) => live.flat(state, [x, z, -y]);
    const handle = (label, x, y) => live.follow(label, (state) => flat(state, state[x], state[y]), { [x]: [-2, 2], [y]: [-2, 2] });

    live.figure('vectors', {
        area: { x: [-2.9, 2.9], y: [-2.1, 2.1] },
        state: { ax: 1.5, ay: -0.5, bx: 1.3, by: 0.9, step: 0, yaw: 0.4, pitch: 0.7 },
        numbers: 4,
        handles: [handle('the vector a', 'ax', 'ay'), handle('the vector b', 'bx', 'by')],
        draw(pen, state, { projection: p, reflected, cross, angle: [angle] }) {
            const { ax, ay, bx, by, step } = state;
            const to = (...place) => flat(state, ...place);
            const [o, a, b] = [to(0, 0), to(ax, ay), to(bx, by)];
            pen.path([to(-2, -2), to(2, -2), to(2, 2), to(-2, 2)], 'thin', true);
            if (step >= 1) {
                pen.path([o, a, to(ax + bx, ay + by), b], 'c pale', true);
                pen.arrow(o, to(0, 0, cross[2] / 2), 'c');
                pen.text(to(0, 0, cross[2] / 2 + 0.2), '½ a × b ', 'c', 'end');
            }
            if (step >= 2 && angle) {
                const start = Math.atan2(by, bx);
                const turn = Math.sign(cross[2] || 1) * -angle * (Math.PI / 180);
                const at = (i) => to(0.4 * Math.cos(start + (turn * i) / 24), 0.4 * Math.sin(start + (turn * i) / 24));
                pen.path(Array.from({ length: 25 }, (_, i) => at(i)), 'ink');
                const [x, y] = at(12);
                pen.text([1.7 * x, 1.7 * y - 0.2], 'α', '', 'middle');
            }
            if (p.length) {
                step === 3 ? pen.arrow(o, to(...p), 'c wide part-fraction') : pen.line(o, to(...p), 'c wide part-fraction');
                pen.line(a, to(...p), 'thin');
                if (step >= 4) {
                    const [wx, wy] = [by, -bx].map((x) => (1.5 * x) / Math.hypot(bx, by));
                    pen.line(to(-wx, -wy), to(wx, wy), 'ink wide');
                    pen.arrow(o, to(...reflected), 'a', 'r');
                }
            }
            pen.arrow(o, a, 'a', 'a');
            pen.arrow(o, b, 'b', 'b');
        },
        grows: [
            ['a02', 'the-dot-product', 'Drag the vectors, and turn the table', 'Both vectors lie on the table. The wide line is the shadow of a on b; its length times that of b is the dot product. A drag beside the vectors turns the table.', {
                question: {
                    text: 'The vector a turns until it points away from b, by more than a right angle. The dot product is then…',
                    choices: ['positive', 'zero', 'negative'],
                    right: 2,
                    because: 'the cosine of an angle above 90 degrees is negative. The shadow lies behind the start of b.',
                },
                values: { dot: 'a · b', cosine: 'cosine of the angle' },
            }],
            ['a02', 'the-cross-product', 'And the cross product', 'It stands upright on the table, drawn at half its length, which is the pale area. Drag a around b: it changes sides.', { values: { dot: 'a · b', area: '|a × b|' } }],
            ['a02', 'the-angle', 'And the angle', 'From the cross product and the dot product, by the arc tangent of both.', { values: { dot: 'a · b', area: '|a × b|', angle: 'angle in degrees' } }],
            ['a02', 'projection', 'And the projection', 'The shadow as a vector. The dashed rest of a stands at a right angle to b.', { values: { 'projection.0': 'projection: x', 'projection.1': 'y' } }],
            ['a02', 'reflection', 'And the reflection', 'The wide line is a mirror, and b its normal; r is the reflected a, which has the same projection.', { values: { 'reflected.0': 'reflection: x', 'reflected.1': 'y' } }],
        ],
    });
}
