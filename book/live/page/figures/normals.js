// A transformed sphere: the ray in both spaces, and its normal moved rightly and wrongly.
{
    const sliders = {
        sx: { label: 'scale x', min: 0.2, max: 3, step: 0.1 },
        sy: { label: 'scale y', min: 0.2, max: 2, step: 0.1 },
        angle: { label: 'turned, degrees', min: -180, max: 180, step: 5 },
    };
    const ray = [live.handle('origin of the ray', 'ox', 'oy'), live.handle('a point of the ray', 'x', 'y')];
    const drawSphere = (pen, m) => {
        const around = Array.from({ length: 73 }, (_, i) => [Math.cos((i * Math.PI) / 36), Math.sin((i * Math.PI) / 36)]);
        pen.path(around.map(([x, y]) => [m[0] * x + m[1] * y + m[3], m[4] * x + m[5] * y + m[7]]), 'a pale', true);
    };

    live.figure('spaces', {
        below: 'scene-graph.svg',
        title: 'The same ray in both spaces',
        hint: 'Left the world, right the space of the object, where the sphere is round. The ray is taken back by the inverse matrix, and its direction keeps the length that it then has, so that t is the same.',
        question: {
            text: 'A sphere is made twice as large, in all directions. In the space of the object, the direction of the ray has the length…',
            choices: ['1', '1/2', '2'],
            right: 1,
            because: 'the inverse of a scaling by 2 is a scaling by 1/2. In object space the hit is half as far away, in steps that are half as long: t is the same.',
        },
        area: { x: [-3, 6], y: [-2.2, 2.2] },
        state: { sx: 2, sy: 0.8, angle: 20, tx: 0, ty: 0, ox: -2.6, oy: 1.8, x: -1.7, y: 1.15 },
        sliders,
        handles: [...ray, live.handle('translation', 'tx', 'ty')],
        values: {
            't_world': 't in the world', 't_object': 't in object space',
            'length': 'length of the direction in object space',
            'matrix.0': 'rows of the matrix M:', 'matrix.1': '', 'matrix.2': '', 'matrix.3': '',
            'matrix.4': ' / ', 'matrix.5': '', 'matrix.6': '', 'matrix.7': '',
        },
        draw(pen, { ox, oy }, answer) {
            const { matrix, direction: [dx, dy], t_world, t_object, object_origin: o, object_direction: d } = answer;
            drawSphere(pen, matrix);
            pen.arrow([ox, oy], [ox + 7 * dx, oy + 7 * dy], 'ink');
            pen.text([ox, oy - 0.75], 'o', '', 'end');
            // The space of the object lies on the right, around (4.5, 0).
            const right = ([x, y]) => [x + 4.5, y];
            pen.shapes.push(`<rect class="live-paper" x="${pen.to([3, 0])[0]}" y="0" width="${3 * pen.scale}" height="${pen.height}"/>`);
            pen.line([3, -2.2], [3, 2.2], 'thin');
            pen.circle([4.5, 0], 1, 'a pale');
            const object = (t) => right([o[0] + t * d[0], o[1] + t * d[1]]);
            // Only the part of the line that lies on the right.
            const inside = Array.from({ length: 400 }, (_, i) => object(i * 0.02)).filter(([x]) => x > 3.02 && x < 6);
            if (inside.length > 1) {
                pen.arrow(inside[0], inside.at(-1), 'ink');
            }
            if (t_world.length) {
                pen.dot([ox + t_world[0] * dx, oy + t_world[0] * dy], 'b');
                pen.dot(object(t_object[0]), 'b');
            }
            pen.text([-2.95, -2.15], 'world');
            pen.text([3, -2.15], 'object space');
        },
    });

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
        sliders,
        handles: ray,
        values: {
            'normal.0': 'normal: x', 'normal.1': 'y',
            'wrong_normal.0': 'moved as a vector: x', 'wrong_normal.1': 'y',
            apart: 'degrees between both',
        },
        draw(pen, { ox, oy }, { matrix, direction: [dx, dy], t_world, normal, wrong_normal }) {
            drawSphere(pen, matrix);
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
}
