// A shadow ray's offset, from acne to shadows that come off.
live.figure('offset', {
    below: 'rounding-offset.svg',
    title: 'Offset the shadow rays',
    hint: 'Each shadow ray starts this far above its surface. The drawing shows one of them, magnified: upwards are powers of ten, from the roundings of the hit to the size of the objects. Wrong pixels are those that differ from the picture with the offset of secondary_ray.',
    question: {
        text: 'Without any offset, the shadow ray starts at the computed hit, which rounding has moved off its surface. How many pixels will be wrong?',
        choices: ['a few', 'a tenth', 'most of the picture'],
        right: 2,
        because: '48,412 of 57,600: wherever rounding leaves the surface ahead of its own shadow ray, it shadows itself: acne. Slide the offset down to the left end to see it. From 10 to the -14 up no pixel is wrong, until shadows come off their objects, from a thousandth on.',
    },
    area: { x: [0, 4], y: [-0.5, 3] },
    picture: [240, 240],
    state: { power: -15 },
    sliders: { power: { label: 'offset: 10 to the', min: -18, max: 0, step: 0.25 } },
    values: { offset: 'offset', wrong_pixels: 'wrong pixels of 57600' },
    draw(pen, { power }, { wrong_pixels: [wrong] }) {
        const height = (power) => (power + 18) / 6;
        const [rounding, objects] = [height(-14.5), height(-3)];
        const band = (low, high, kind) => pen.path([[0, low], [4, low], [4, high], [0, high]], `${kind} pale`, true);
        band(0, rounding, 'b');
        band(objects, 3, 'a');
        pen.line([0, 0], [4, 0], 'ink wide');
        pen.text([3.93, 0.05], 'roundings of the hit', 'b', 'end');
        pen.text([3.93, 2.7], 'objects that cast shadows', 'a', 'end');
        [-12, -6].forEach((power) => pen.text([0, height(power) - 0.1], power === -12 ? '10⁻¹²' : '10⁻⁶'));
        const start = [1.6, height(power)];
        pen.arrow([1.6, 0], start, 'c part-OFFSET');
        pen.text([1.55, start[1] / 2 - 0.1], 'offset', 'c', 'end');
        pen.dot(start, 'c', 6);
        const isBlocked = start[1] < rounding && wrong > 0;
        const end = isBlocked ? [2.1, 0] : [3.2, start[1] + 1.1];
        pen.arrow(start, end, isBlocked ? 'b wide' : 'ink');
        const verdict = isBlocked ? 'meets its own surface: dark speckles' : start[1] > objects ? 'starts beyond objects: light in shadows' : 'free, up to the first object';
        pen.text([2, -0.5], verdict, isBlocked || start[1] > objects ? 'b' : 'c', 'middle');
    },
});
