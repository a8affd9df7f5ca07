// One scene that grows with the stages, seen from aside, and the path of one ray through it.
{
    const eye = [0, 1.4, 4.4];
    // The picture before the eye; the reader drags one of its pixels.
    const screen = 3.2;
    // The middle of the drawing.
    const middle = [0, 1.25, 1.6];
    const flat = (state, point) => live.flat(state, point.map((x, i) => x - middle[i]));
    // Steps with a drawing of their own; the lamp stays.
    const [nearest, lamp, highlight] = [4, 5, 7];
    const met = { t: 't of the hit' };
    const lit = { ...met, cosine: 'n · l', 'color.0': 'colour: red', 'color.1': 'green', 'color.2': 'blue' };

    live.figure('scene', {
        over: true,
        picture: [360, 270],
        area: { x: [-2.67, 2.67], y: [-2, 2] },
        state: { x: 0.2, y: 1.2, depth: 6, coarse: 1, yaw: 0.8, pitch: 0.35 },
        handles: [
            live.follow('the pixel', (state) => flat(state, [state.x, state.y, screen]), { x: [-0.55, 0.55], y: [1, 1.8] }),
        ],
        values: lit,
        draw(pen, state, { path, hits, lamp: [...bulb], normal, reflected, blocked }) {
            const to = (point) => flat(state, point);
            const { step } = state;
            const corners = [[-0.6, 0.95], [0.6, 0.95], [0.6, 1.85], [-0.6, 1.85]].map((place) => to([...place, screen]));
            corners.forEach((corner) => pen.line(to(eye), corner, 'thin'));
            pen.path(corners, 'ink pale', true);
            pen.dot(to(eye), 'ink');
            pen.text(to(eye), 'eye', '', 'end');
            if (step >= lamp) {
                pen.dot(to(bulb), 'b', 6);
                pen.text(to(bulb), 'lamp', 'b');
            }
            live.points(hits).forEach((hit, i) => {
                const t = Math.hypot(...hit.map((x, i) => x - eye[i]));
                pen.dot(to(hit), 'none');
                const [x, y] = to(hit);
                pen.text([x, y + 0.25 * i], step === nearest ? `t = ${live.show(Number(t.toPrecision(3)))}` : '', '', x > 1.6 ? 'end' : 'middle');
            });
            const way = live.points(path).map(to);
            way.slice(1).forEach((end, i) => pen.arrow(way[i], end, i ? 'c part-mirrored' : 'ink'));
            if (!normal) {
                return;
            }
            const [, point] = way;
            pen.dot(point, 'ink');
            pen.arrow(point, to(normal), 'a part-face part-hit', 'n');
            if (step >= lamp) {
                pen.line(point, to(bulb), blocked.length ? 'b thin part-light part-way' : 'b part-light part-way');
                live.points(blocked).forEach((stop) => pen.text(to(stop), '✕', 'b', 'middle'));
            }
            if (step === highlight) {
                pen.arrow(point, to(reflected), 'b', 'r', 'end');
            }
        },
        grows: [
            ['a04', 'plane', 'The scene so far: a plane', 'The scene from aside, rendered by the lesson. At the left the eye and its picture; drag the pixel, and its ray meets another point. A drag beside it turns the scene. Dots are hits, and n is the normal.', { values: met, state: { y: 1.05 } }],
            ['a04', 'sphere', 'The scene so far: a sphere on the plane', 'The ray meets sphere and plane, and ends at the nearer one: the full dot.', { values: met }],
            ['a04', 'box', 'The scene so far: and a box', 'Drag the pixel to the left until the ray meets the box: the normal is that of the face.', { values: met }],
            ['a04', 'triangle', 'The scene so far: and a triangle', 'Behind the others stands a triangle. Its normal points to both sides: facing turns it towards the eye.', { values: met }],
            ['a04', 'hit-and-world', 'All hits, and the nearest', 'One hit for each object that the ray meets, with its t: here sphere, triangle and plane. Only the nearest one is seen.', { values: met, state: { x: 0.13, y: 1.1 } }],
            ['a05', 'two-questions', 'The scene so far: a lamp', 'The scene of the stage before. The line to the lamp is the direction l of the hit. As yet each surface has one colour.'],
            ['a05', 'lambert-the-cosine', 'The scene so far: matt', 'By Lambert. The larger the angle between n and l, the darker the pixel.'],
            ['a05', 'phong-the-highlight', 'The scene so far: shiny', 'By Phong; r is l, mirrored at n. Drag the pixel over the sphere until r points at the eye: there is the highlight of your ray. The scene from aside has its own, for an eye where you are.'],
            ['a05', 'three-lights', 'The scene so far: a spot light', 'The lamp lights a cone; ambient light does the rest.'],
            ['a06', 'is-the-light-in-sight', 'The scene so far: shadows', 'The dashed line to the lamp is a shadow ray that meets something, at the cross. Drag the pixel into a shadow.'],
            ['a06', 'the-mirror', 'The scene so far: mirrors', 'All surfaces mirror three tenths, and a ray may hit two of them: the green arrow is the reflected ray.'],
            ['a06', 'how-deep', 'The scene so far: six surfaces deep', 'Mirrors in mirrors. Drag the pixel to the place where sphere and plane meet, and follow the path, bounce by bounce: World::hit, reflected_on and secondary_ray, in the order of the loop.', {
                question: {
                    text: 'Each mirror reflects one half. After how many surfaces is a white lamp at the end below one step of a byte, 1/255?',
                    choices: ['3', '8', '255'],
                    right: 1,
                    because: 'one half to the 8th is 1/256. These mirrors reflect three tenths: five of them leave 0.24 %, below one step.',
                },
                sliders: { depth: { label: 'surfaces', min: 1, max: 12, step: 1 } },
                values: { left: 'fraction left after the last surface', ...lit },
            }],
            ['a07', 'four-rows-for-three-dimensions', 'The scene so far: a scaled sphere', 'The sphere is in a node now, scaled by 0.6, 1.4 and 0.6 about its centre.'],
            ['a07', 'the-order-of-the-steps', 'The scene so far: a turned box', 'The box is first turned about z and then about y.'],
            ['a07', 'node', 'The scene so far: nodes in a node', 'One more node around all objects turns them together.', { state: { x: 0.31 } }],
            ['a07', 'disc', 'The whole scene', 'On a disc. All seven stages are in this picture.', { state: { x: 0.31 } }],
        ],
    });
}
