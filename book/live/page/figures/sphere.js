// A ray and a sphere, from near and from 100 million radii away.
live.figure('sphere', {
    below: 'sphere-quadratic.svg',
    title: 'Drag the ray and the sphere, then move the origin far away',
    hint: 'The roots t₀ and t₁, counted from the origin of the ray, by the code of this stage and by the protocol’s formula, whose rings in the drawing then leave the dots of ours. Errors are against a computation with 30 digits, in radii. Our discriminant r² − l·l is shown times 4a, which makes it b² − 4ac.',
    question: {
        text: 'A double has 16 digits. From how far away does the protocol’s formula no longer find the sphere where it is?',
        choices: ['a million radii', 'a hundred million radii', 'never'],
        right: 1,
        because: 'b² and 4ac are as large as the squared distance. At 10⁸ radii that is 10¹⁶, and they agree in all 16 digits: their difference, which decides hit or miss, is rounding. Slide the distance up and watch both errors and discriminants.',
    },
    area: { x: [-2.4, 2.4], y: [-1.5, 1.5] },
    state: { x: -0.6, y: 0.5, angle: 0.1, power: 0.3, cx: 0, cy: 0 },
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
    draw(pen, { x, y, power, cx, cy }, { origin, direction: [dx, dy], ours, protocol }) {
        const far = 10 ** power;
        // From the point that the reader drags, since the origin may be far away.
        const at = (t) => [x + (t - far) * dx, y + (t - far) * dy];
        pen.circle([cx, cy], 1, 'a pale');
        pen.dot([cx, cy], 'a');
        pen.arrow(at(Math.max(0, far - 6)), at(far + 6), 'ink');
        pen.dot(origin, 'ink');
        pen.text(origin, 'o');
        protocol.forEach((t) => pen.circle(at(t), 0.09, 'b'));
        ours.forEach((t, i) => {
            pen.dot(at(t), 'c');
            pen.text(at(t), ['t₀', 't₁'][i], 'c');
        });
        pen.text([-2.35, -1.45], 'filled: ours, rings: protocol');
    },
});
