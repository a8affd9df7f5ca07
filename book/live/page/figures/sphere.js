// A ray and a sphere, from near and from 100 million radii away.
live.figure('sphere', {
    below: 'sphere-quadratic.svg',
    title: 'Drag the ray and the sphere, then move the origin far away',
    hint: 'The roots t₀ and t₁, counted from the origin of the ray, by the code of this stage and by the protocol’s formula: from far away its rings leave the dots of ours, and the dashed circle is the sphere that it sees. Errors are against a computation with 30 digits, in radii. Our discriminant r² − l·l is shown times 4a, which makes it b² − 4ac.',
    question: {
        text: 'A double has 16 digits. From how far away does the protocol’s formula no longer find the sphere where it is?',
        choices: ['a million radii', 'a hundred million radii', 'never'],
        right: 1,
        because: 'b² and 4ac are as large as the squared distance. At 10⁸ radii that is 10¹⁶, and they agree in all 16 digits: their difference, which decides hit or miss, is rounding. Slide the distance up and watch both errors and discriminants.',
    },
    area: { x: [-2.4, 2.4], y: [-1.5, 1.5] },
    state: { x: -0.5, y: 0.5, angle: 0.1, power: 0.2, cx: 0, cy: 0 },
    sliders: {
        power: { label: 'distance of the origin: 10 to the', min: 0, max: 8.5, step: 0.1 },
    },
    handles: [
        live.handle('a point of the ray', 'x', 'y'),
        live.angleHandle('direction of the ray', 'angle', 0.7, ({ x, y }) => [x, y]),
        live.handle('centre of the sphere', 'cx', 'cy'),
    ],
    values: {
        'ours.0': 't₀, ours',
        'protocol.0': 't₀, protocol',
        'ours.1': 't₁, ours',
        'protocol.1': 't₁, protocol',
        our_error: 'error of t₀, ours',
        protocol_error: 'error of t₀, protocol',
        exact_discriminant: 'discriminant b² − 4ac, exact',
        our_discriminant: 'ours',
        protocol_discriminant: 'protocol',
    },
    draw(pen, { x, y, angle, power, cx, cy }, { direction: [dx, dy], ours, protocol }) {
        const far = 10 ** power;
        // From the point that the reader drags, since the origin may be far away.
        const at = (t) => [x + (t - far) * dx, y + (t - far) * dy];
        // An origin beyond the drawing is drawn at its border, before dashes.
        const nearest = Math.min(far, dx ? (x + Math.sign(dx) * 2.15) / dx : far, dy ? (y + Math.sign(dy) * 1.3) / dy : far);
        const [isFar, origin] = [nearest < far, at(far - Math.max(nearest, 0))];
        pen.circle([cx, cy], 1, 'a pale');
        const gap = at(far - Math.max(nearest - (isFar ? 0.5 : 0), 0));
        pen.line(origin, gap, 'thin');
        pen.arrow(gap, at(far + 6), 'ink');
        pen.dot(origin, 'ink');
        pen.text([origin[0], origin[1] - 0.35], isFar ? `o, ${live.show(Number(far.toPrecision(2)))} radii away` : 'o', '', dx < 0 ? 'end' : 'start');
        // The middle of the chord, and the sphere that the protocol's roots belong to.
        const middle = at(far + (cx - x) * dx + (cy - y) * dy);
        let radius = 0;
        if (protocol.length) {
            const [t0, t1] = protocol;
            const seen = at((t0 + t1) / 2);
            const beside = [cx - middle[0], cy - middle[1]];
            radius = Math.hypot(...beside, (t1 - t0) / 2);
            pen.circle([seen[0] + beside[0], seen[1] + beside[1]], radius, 'b thin');
        }
        if (Math.abs(radius - 1) > 0.01) {
            pen.text([cx, cy + 1.05], radius ? `protocol: a radius of ${live.show(Number(radius.toPrecision(2)))}` : 'protocol: no hit', 'b', 'middle');
        }
        protocol.forEach((t) => pen.circle(at(t), 0.09, 'b'));
        if (ours.length) {
            pen.line([cx, cy], middle, 'a thin');
            pen.line(middle, at(ours[1]), 'c part-discriminant');
            pen.dot(middle, 'ink part-middle', 3);
            pen.text([middle[0], middle[1] - 0.32], 'm', 'part-middle', 'middle');
        }
        ours.forEach((t, i) => {
            pen.dot(at(t), 'c');
            pen.text(at(t), ['t₀', 't₁'][i], 'c', 'end');
        });
        pen.text([x, y + 0.18], 'point', '', 'middle');
        pen.text([x + 0.7 * Math.cos(angle), y + 0.7 * Math.sin(angle) + 0.18], 'd', '', 'middle');
        pen.text([cx, cy - 0.42], 'c', 'a', 'middle');
        pen.text([-2.35, -1.45], 'filled: ours; rings and dashes: protocol');
    },
});
