// A shadow ray's lift, from acne to shadows that come off.
live.figure('lift', {
    below: 'rounding-lift.svg',
    title: 'Lift the shadow rays',
    hint: 'Each shadow ray starts this far above its surface. Wrong pixels are those that differ from the picture with the lift of secondary_ray.',
    question: {
        text: 'Without any lift, the shadow ray starts at the computed hit, which rounding has moved off its surface. How many pixels will be wrong?',
        choices: ['a few', 'half of the floor', 'most of the picture'],
        right: 2,
        because: 'wherever rounding leaves the surface ahead of its own shadow ray, it shadows itself: acne. Slide the lift down to the left end to see it. From 10 to the -14 up no pixel is wrong, until shadows come off their objects, from a thousandth on.',
    },
    picture: [240, 240],
    state: { power: -13 },
    sliders: { power: { label: 'lift: 10 to the', min: -18, max: 0, step: 0.25 } },
    values: { lift: 'lift', wrong_pixels: 'wrong pixels of 57600' },
});
