// A camera that grows: a ray from its eye, its axes, and the rays through its picture.
{
    const flat = live.flat;
    const add = (p, v, t = 1) => p.map((x, i) => x + t * v[i]);

    // Places of the handles; the axes of the drawing come from the module.
    const radians = Math.PI / 180;
    const eye = ({ x, y, z }) => [x, y, z];
    const gaze = ({ around, upwards }) => {
        const level = Math.cos(upwards * radians);
        return [-Math.sin(around * radians) * level, Math.sin(upwards * radians), -Math.cos(around * radians) * level];
    };
    const up = ({ around, roll }) => {
        const [sine, cosine] = [Math.sin(roll * radians), Math.cos(roll * radians)];
        return [Math.cos(around * radians) * sine, cosine, -Math.sin(around * radians) * sine];
    };
    const cross = ([a, b, c], [d, e, f]) => [b * f - c * e, c * d - a * f, a * e - b * d];
    const unit = (v) => v.map((x) => x / Math.hypot(...v));
    // The picture in the drawing lies this far ahead of the eye.
    const ahead = 2.5;
    const top = (state) => {
        const g = gaze(state);
        const v = cross(unit(cross(g, up(state))), g);
        return add(add(eye(state), g, ahead), v, ahead * Math.tan((state.opening * radians) / 2));
    };

    const eyeHandle = live.follow('the eye, at its height', (state) => flat(state, eye(state)), { x: [-9, 9], z: [-9, 9] });
    const gazeHandle = live.follow('the gaze', (state) => flat(state, add(eye(state), gaze(state), ahead)), {
        around: [-180, 180],
        upwards: [-80, 80],
    });

    live.figure('camera', {
        area: { x: [-3.8, 7.4], y: [-1.9, 5.7] },
        state: { x: 4, y: 4, z: 4, around: 45, upwards: -35, roll: 0, opening: 45, step: 0, yaw: -0.45, pitch: 0.35 },
        numbers: 8,
        handles: [
            eyeHandle,
            gazeHandle,
            live.follow('the up vector', (state) => flat(state, add(eye(state), up(state), 1.8)), { roll: [-80, 80] }),
            live.follow('the opening', (state) => flat(state, top(state)), { opening: [5, 120] }),
        ],
        picture: [240, 180],
        draw(pen, state, { u, v, w, gaze, up, origins, corners, samples }) {
            const { step } = state;
            const e = eye(state);
            const to = (point) => flat(state, point);
            const outline = (points, kind) => pen.path(points.map(to), kind, true);
            outline([[-3, 0, -3], [3, 0, -3], [3, 0, 3], [-3, 0, 3]], 'thin');
            if (step !== 4) {
                const box = (y) => [[-1.5, y, 0.5], [-0.5, y, 0.5], [-0.5, y, 1.5], [-1.5, y, 1.5]];
                outline(box(0.5), 'a');
                outline(box(1.5), 'a pale');
                pen.circle(to([1, 1, 1]), 0.5, 'c pale');
                outline([[0, 0, -1], [1, 0, -1], [1, 1, -1]], 'b pale');
            }
            pen.dot(to(e), 'ink');
            pen.line(to(e), to([e[0], 0, e[2]]), 'thin');
            if (step === 0) {
                pen.arrow(to(e), to(add(e, gaze, 8)), 'ink');
                for (let t = 0; t < 8; t += 1) {
                    pen.dot(to(add(e, gaze, t)), 'b', 3);
                    pen.text(to(add(e, gaze, t)), t % 2 ? '' : `t = ${t}`, 'b', 'end');
                }
                return;
            }
            [[u, 'a part-right', 'u'], [v, 'c', 'v'], [w, 'b', 'w']].forEach(([axis, kind, name]) => {
                pen.arrow(to(e), to(add(e, axis, 1.3)), kind);
                pen.text(to(add(e, axis, 1.5)), name, kind);
            });
            pen.line(to(e), to(add(e, up, 1.8)), 'thin');
            pen.text(to(add(e, up, 1.9)), 't', '', 'end');
            if (step === 1) {
                return;
            }
            // The rays, up to the plane of the picture.
            const along = (d) => ahead / d.reduce((sum, x, i) => sum + x * gaze[i], 0);
            const starts = live.points(origins);
            const directions = live.points(corners);
            const picture = directions.map((d, i) => add(starts[i], d, along(d)));
            picture.forEach((corner, i) => pen.line(to(starts[i]), to(corner), 'thin'));
            outline(picture, 'ink pale');
            if (step === 2) {
                outline(starts, 'ink');
            } else if (step === 5) {
                live.points(samples).forEach((d) => pen.line(to(e), to(add(e, d, along(d))), 'b'));
            }
        },
        grows: [
            ['a03', 'the-ray', 'A ray from an eye', 'The line is the ray, the dots are Ray::at for each t: a step of t is one length of the direction, which is 1. The picture is the goal of the chapter: it has a ray of this kind for each pixel. Drag the eye and the gaze, or turn the drawing by a drag beside them.', { handles: [eyeHandle, gazeHandle] }],
            ['a03', 'the-cameras-own-axes', 'Three axes on the eye', 'Handles: the eye, at its height; the gaze; the end of the up vector t, dashed; the field of view. The axes u, v and w are computed by Basis::new. A drag beside the handles turns the drawing.', {
                question: {
                    text: 'The up vector leans to the right. In the picture, the objects lean…',
                    choices: ['to the left', 'to the right', 'not at all'],
                    right: 0,
                    because: 'the picture’s upward axis v follows the up vector; seen from a head that leans right, the world leans left.',
                },
                sliders: { y: { label: 'height of the eye', min: 0.2, max: 6, step: 0.1 } },
                values: { 'u.0': 'u =', 'u.1': '', 'u.2': '', 'v.0': 'v =', 'v.1': '', 'v.2': '', 'w.0': 'w =', 'w.1': '', 'w.2': '' },
            }],
            ['a04', 'the-orthographic-camera', 'All rays are parallel', 'The rays through the corners of the picture start in a rectangle around the eye, by OrthographicCamera. In the picture, edges that are parallel stay so.'],
            ['a03', 'perspective', 'All rays start in the eye', 'The edges of the pyramid are the rays through the corners of the picture, by PerspectiveCamera. A wider opening shows more, and all of it smaller.'],
            ['a03', 'the-striped-sky', 'A sky', 'The rays meet nothing: their directions alone choose the stripes. Let the gaze climb, and the stripes bend.', { state: { upwards: 0 } }],
            ['a03', 'many-rays-per-pixel', 'Sixteen rays per pixel', 'The fan goes through one pixel, drawn as large as a quarter of the picture is wide, at the stratified places of Sampler. The edges in the picture have no stairs any more.'],
        ],
    });
}
