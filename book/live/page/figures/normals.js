// A transformed sphere: the ray in both spaces, and normals moved rightly and wrongly.
live.figure('normals', {
    below: 'scene-graph.svg',
    title: 'The same ray in the world and in the space of the object',
    hint: 'Left the world, right the space of the sphere, where the ray’s direction keeps its changed length, so that t is the same. The grey arrow is the normal moved by the matrix itself, as a vector is.',
    question: {
        text: 'A sphere is stretched in x. Moved like vectors, its normals would lean…',
        choices: ['too far to the x axis', 'too far away from it', 'rightly'],
        right: 0,
        because: 'stretching in x makes the surface flatter, so its normals have to turn towards y; the matrix stretches them along x instead.',
    },
    area: { x: [-3, 6], y: [-2.2, 2.2] },
    state: { sx: 2, sy: 0.8, angle: 20, tx: 0, ty: 0, ox: -2.6, oy: 1.8, x: -0.6, y: 0.4 },
    sliders: {
        sx: { label: 'scale x', min: 0.2, max: 3, step: 0.1 },
        sy: { label: 'scale y', min: 0.2, max: 2, step: 0.1 },
        angle: { label: 'turned, degrees', min: -180, max: 180, step: 5 },
    },
    handles: [
        live.handle('origin of the ray', 'ox', 'oy'),
        live.handle('a point of the ray', 'x', 'y'),
        live.handle('translation', 'tx', 'ty'),
    ],
    values: {
        't_world': 't in the world', 't_object': 't in the object’s space',
        'normal.0': 'normal x', 'normal.1': 'y',
        'wrong_normal.0': 'moved as a vector: x', 'wrong_normal.1': 'y',
        'matrix.0': 'first row of the matrix', 'matrix.1': '', 'matrix.3': '… and',
        'matrix.4': 'second row', 'matrix.5': '', 'matrix.7': '… and',
    },
    draw(pen, { ox, oy }, answer) {
        const { matrix: m, direction: [dx, dy], t_world, normal, wrong_normal } = answer;
        const around = Array.from({ length: 73 }, (_, i) => [Math.cos((i * Math.PI) / 36), Math.sin((i * Math.PI) / 36)]);
        pen.path(around.map(([x, y]) => [m[0] * x + m[1] * y + m[3], m[4] * x + m[5] * y + m[7]]), 'a pale', true);
        pen.arrow([ox, oy], [ox + 7 * dx, oy + 7 * dy], 'ink');
        // The space of the object lies on the right, around (4.5, 0).
        const right = ([x, y]) => [x + 4.5, y];
        pen.shapes.push(`<rect class="live-paper" x="${pen.to([3, 0])[0]}" y="0" width="${3 * pen.scale}" height="${pen.height}"/>`);
        pen.line([3, -2.2], [3, 2.2], 'thin');
        pen.circle([4.5, 0], 1, 'c pale');
        const { object_origin: o, object_direction: d, t_object, object_normal } = answer;
        const object = (t) => right([o[0] + t * d[0], o[1] + t * d[1]]);
        // Only the part of the line that lies on the right.
        const inside = Array.from({ length: 400 }, (_, i) => object(i * 0.02)).filter(([x]) => x > 3.02 && x < 6);
        if (inside.length > 1) {
            pen.arrow(inside[0], inside.at(-1), 'ink');
        }
        if (t_world?.length) {
            const [t] = t_world;
            const p = [ox + t * dx, oy + t * dy];
            pen.arrow(p, [p[0] + wrong_normal[0], p[1] + wrong_normal[1]], 'ink');
            pen.arrow(p, [p[0] + normal[0], p[1] + normal[1]], 'b');
            pen.dot(p, 'b');
            const q = object(t_object[0]);
            pen.arrow(q, [q[0] + object_normal[0], q[1] + object_normal[1]], 'b');
            pen.dot(q, 'b');
        }
        pen.text([-2.95, -2.15], 'world');
        pen.text([3, -2.15], 'space of the object');
    },
});
