// A transformed sphere: its normal moved rightly, and wrongly as a vector is.
live.figure('normals', {
    below: 'normal-squeezed.svg',
    title: 'Move the normal, rightly and wrongly',
    hint: 'The orange normal is moved by the transposed inverse, as normal_from_object does, the dashed one by the matrix itself. The green line is the tangent at the hit.',
    question: {
        text: 'A sphere is stretched in x. Moved like vectors, its normals would lean…',
        choices: ['too far to the x axis', 'too far away from it', 'rightly'],
        right: 0,
        because: 'stretching in x makes the surface flatter, so its normals have to turn towards y; the matrix stretches them along x instead.',
    },
    area: { x: [-3, 3], y: [-2.2, 2.2] },
    state: { sx: 2, sy: 0.8, angle: 0, tx: 0, ty: 0, ox: -2.4, oy: 1.6, x: -1.2, y: 0.5 },
    sliders: {
        sx: { label: 'scale x', min: 0.2, max: 3, step: 0.1 },
        sy: { label: 'scale y', min: 0.2, max: 2, step: 0.1 },
        angle: { label: 'turned, degrees', min: -180, max: 180, step: 5 },
    },
    handles: [live.handle('origin of the ray', 'ox', 'oy'), live.handle('a point of the ray', 'x', 'y')],
    values: {
        'normal.0': 'normal: x', 'normal.1': 'y',
        'wrong_normal.0': 'moved as a vector: x', 'wrong_normal.1': 'y',
        apart: 'degrees between both',
    },
    draw(pen, { ox, oy }, { matrix: m, direction: [dx, dy], t_world, normal, wrong_normal }) {
        const around = Array.from({ length: 73 }, (_, i) => [Math.cos((i * Math.PI) / 36), Math.sin((i * Math.PI) / 36)]);
        pen.path(around.map(([x, y]) => [m[0] * x + m[1] * y + m[3], m[4] * x + m[5] * y + m[7]]), 'a pale', true);
        if (!t_world.length) {
            pen.arrow([ox, oy], [ox + 7 * dx, oy + 7 * dy], 'ink');
            return;
        }
        const [x, y] = [ox + t_world[0] * dx, oy + t_world[0] * dy];
        const [nx, ny] = normal;
        pen.arrow([ox, oy], [x, y], 'ink');
        pen.line([x - ny, y + nx], [x + ny, y - nx], 'c');
        pen.arrow([x, y], [x + wrong_normal[0], y + wrong_normal[1]], 'thin');
        pen.arrow([x, y], [x + nx, y + ny], 'b');
        pen.dot([x, y], 'b');
        pen.text([x + nx, y + ny], 'n', 'b');
    },
});
