// A camera in the scene: what its numbers do to its axes and to the picture.
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

    live.figure('camera', {
        below: 'camera-basis.svg',
        title: 'A camera before four objects',
        hint: 'u, v and w are computed by Basis::new; the four edges of the pyramid are the rays through the corners of the picture on the right, rendered by the lesson.',
        question: {
            text: 'The up vector leans to the right. In the picture, the objects lean…',
            choices: ['to the left', 'to the right', 'not at all'],
            right: 0,
            because: 'the picture’s upward axis v follows the up vector; seen from a head that leans right, the world leans left.',
        },
        area: { x: [-4, 8], y: [-3, 5] },
        state: { x: 4, y: 4, z: 4, around: 45, upwards: -35, roll: 0, opening: 45 },
        sliders: {
            y: { label: 'height of the eye', min: 0.2, max: 6, step: 0.1 },
            around: { label: 'gaze around', min: -180, max: 180, step: 1 },
            upwards: { label: 'gaze upwards', min: -85, max: 85, step: 1 },
            roll: { label: 'up vector leans', min: -80, max: 80, step: 1 },
            opening: { label: 'opening angle', min: 5, max: 120, step: 1 },
        },
        handles: [
            {
                label: 'the eye, at its height',
                at: ({ x, y, z }) => flat([x, y, z]),
                move: ({ y }, px, py) => unflat(px, py, y),
            },
        ],
        picture: [240, 180],
        values: {
            'u.0': 'u =', 'u.1': '', 'u.2': '',
            'v.0': 'v =', 'v.1': '', 'v.2': '',
            'w.0': 'w =', 'w.1': '', 'w.2': '',
        },
        draw(pen, { x, y, z }, { u, v, w, corners }) {
            const e = [x, y, z];
            const outline = (points, kind) => pen.path(points.map(flat), kind, true);
            outline([[-3, 0, -3], [3, 0, -3], [3, 0, 3], [-3, 0, 3]], 'thin');
            const box = (y) => [[-1.5, y, 0.5], [-0.5, y, 0.5], [-0.5, y, 1.5], [-1.5, y, 1.5]];
            outline(box(0.5), 'a');
            outline(box(1.5), 'a pale');
            pen.circle(flat([1, 1, 1]), 0.5, 'c pale');
            outline([[0, 0, -1], [1, 0, -1], [1, 1, -1]], 'b pale');
            const directions = [0, 3, 6, 9].map((i) => corners.slice(i, i + 3));
            directions.forEach((d) => pen.line(flat(e), flat(add(e, d, 3)), 'thin'));
            outline(directions.map((d) => add(e, d, 3)), 'ink');
            [[u, 'a', 'u'], [v, 'c', 'v'], [w, 'b', 'w']].forEach(([axis, kind, name]) => {
                pen.arrow(flat(e), flat(add(e, axis, 1.5)), kind);
                pen.text(flat(add(e, axis, 1.7)), name, kind);
            });
            pen.line(flat(e), flat([x, 0, z]), 'thin');
        },
    });
}
