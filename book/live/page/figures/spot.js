// The cone of a spot light.
live.figure('spot', {
    below: 'spot-cone.svg',
    title: 'Drag the point and the axis',
    hint: 'SpotLight::illumination compares cosines: the point is lit if v·w is at least the cosine of the half angle.',
    question: {
        text: 'The half angle is 60 degrees, and a point lies exactly 60 degrees off the axis. It is…',
        choices: ['lit', 'dark'],
        right: 0,
        because: 'the edge belongs to the cone. A larger angle has a smaller cosine, so lit is where v·w is at least the cosine of the half angle, here 1/2.',
    },
    area: { x: [-1, 3.5], y: [-1.6, 1.6] },
    state: { axis: 0.15, half_angle: 25, x: 2, y: 0.9 },
    sliders: { half_angle: { label: 'half angle in degrees', min: 1, max: 90, step: 1 } },
    handles: [live.angleHandle('the axis of the cone', 'axis', 1.4), live.handle('the point', 'x', 'y')],
    values: { lit: 'lit (1) or not (0)', cosine: 'v·w', cosine_of_half_angle: 'cosine of the half angle', angle: 'angle in degrees' },
    draw(pen, { axis, half_angle, x, y }, { lit: [lit] }) {
        const half = (half_angle * Math.PI) / 180;
        const at = (angle, length) => [length * Math.cos(angle), length * Math.sin(angle)];
        const rim = Array.from({ length: 33 }, (_, i) => at(axis - half + (half * i) / 16, 6));
        pen.path([[0, 0], ...rim], 'b pale', true);
        pen.arrow([0, 0], at(axis, 1.4), 'ink part-direction');
        pen.arrow([0, 0], [x, y], lit ? 'b' : 'thin');
        pen.dot([0, 0], 'b part-source', 6);
        pen.text([x, y], lit ? 'lit' : 'dark');
    },
});
