// A camera in the scene: its eye, gaze, up vector and opening, and the picture.
{
    // A parallel projection of space for the drawing, from the side and from above; and
    // back, for a known height.
    const [cos, sin, tilt] = [Math.cos(-0.45), Math.sin(-0.45), 0.34];
    const flat = ([x, y, z]) => [cos * x - sin * z, 0.94 * y - tilt * (sin * x + cos * z)];
    const unflat = (px, py, y) => {
        const depth = (0.94 * y - py) / tilt;
        return { x: cos * px + sin * depth, z: cos * depth - sin * px };
    };
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

    live.figure('camera', {
        below: 'camera-basis.svg',
        title: 'Drag the eye, the gaze, the up vector and the opening',
        hint: 'Four handles: the eye, at its height; the middle of the picture, for the gaze; the end of the up vector t, dashed; the middle of the upper edge, for the opening. u, v and w are computed by Basis::new, and the edges of the pyramid are the rays through the corners of the picture on the right, rendered by the lesson.',
        question: {
            text: 'The up vector leans to the right. In the picture, the objects lean…',
            choices: ['to the left', 'to the right', 'not at all'],
            right: 0,
            because: 'the picture’s upward axis v follows the up vector; seen from a head that leans right, the world leans left.',
        },
        area: { x: [-3.8, 7.4], y: [-1.9, 5.5] },
        state: { x: 4, y: 4, z: 4, around: 45, upwards: -35, roll: 0, opening: 45 },
        sliders: {
            y: { label: 'height of the eye', min: 0.2, max: 6, step: 0.1 },
            around: { label: 'gaze around', min: -180, max: 180, step: 1 },
            upwards: { label: 'gaze upwards', min: -80, max: 80, step: 1 },
            roll: { label: 'up vector leans', min: -80, max: 80, step: 1 },
            opening: { label: 'opening angle', min: 5, max: 120, step: 1 },
        },
        handles: [
            {
                label: 'the eye, at its height',
                at: (state) => flat(eye(state)),
                move: ({ y }, px, py) => unflat(px, py, y),
            },
            live.follow('the gaze', (state) => flat(add(eye(state), gaze(state), ahead)), {
                around: [-180, 180],
                upwards: [-80, 80],
            }),
            live.follow('the up vector', (state) => flat(add(eye(state), up(state), 1.8)), { roll: [-80, 80] }),
            live.follow('the opening', (state) => flat(top(state)), { opening: [5, 120] }),
        ],
        picture: [240, 180],
        values: {
            'u.0': 'u =', 'u.1': '', 'u.2': '',
            'v.0': 'v =', 'v.1': '', 'v.2': '',
            'w.0': 'w =', 'w.1': '', 'w.2': '',
        },
        draw(pen, state, { u, v, w, gaze, up, corners }) {
            const e = eye(state);
            const outline = (points, kind) => pen.path(points.map(flat), kind, true);
            outline([[-3, 0, -3], [3, 0, -3], [3, 0, 3], [-3, 0, 3]], 'thin');
            const box = (y) => [[-1.5, y, 0.5], [-0.5, y, 0.5], [-0.5, y, 1.5], [-1.5, y, 1.5]];
            outline(box(0.5), 'a');
            outline(box(1.5), 'a pale');
            pen.circle(flat([1, 1, 1]), 0.5, 'c pale');
            outline([[0, 0, -1], [1, 0, -1], [1, 1, -1]], 'b pale');
            // The rays, up to the plane of the picture.
            const along = (d) => ahead / d.reduce((sum, x, i) => sum + x * gaze[i], 0);
            const picture = [0, 3, 6, 9].map((i) => corners.slice(i, i + 3)).map((d) => add(e, d, along(d)));
            picture.forEach((corner) => pen.line(flat(e), flat(corner), 'thin'));
            outline(picture, 'ink pale');
            [[u, 'a', 'u'], [v, 'c', 'v'], [w, 'b', 'w']].forEach(([axis, kind, name]) => {
                pen.arrow(flat(e), flat(add(e, axis, 1.3)), kind);
                pen.text(flat(add(e, axis, 1.5)), name, kind);
            });
            pen.line(flat(e), flat(add(e, up, 1.8)), 'thin');
            pen.text(flat(add(e, up, 1.8)), 't');
            pen.line(flat(e), flat([e[0], 0, e[2]]), 'thin');
        },
    });
}
