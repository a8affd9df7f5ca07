// Lambert's cosine: a beam, and the piece of the floor that it lights.
live.figure('lambert', {
    below: 'lambert-cosine.svg',
    title: 'Drag the light',
    hint: 'The beam keeps its width. The wide line is the lit piece of the floor, computed for a beam that is 1 wide; the brightness of a white floor is the factor of Lambert::fraction.',
    question: {
        text: 'The light stands 60 degrees away from the normal. How bright is the floor, compared with light from straight above?',
        choices: ['two thirds', 'half', 'a quarter'],
        right: 1,
        because: 'the cosine of 60 degrees is 1/2: the beam lights a piece twice as long, so each bit of it gets half.',
    },
    area: { x: [-2, 2], y: [-0.25, 1.5] },
    state: { light: 2.2 },
    handles: [live.angleHandle('the light', 'light', 1.3)],
    values: { angle: 'angle to the normal', cosine: 'n · l', lit: 'length of the lit piece', diffuse: 'brightness' },
    draw(pen, { light }, { cosine: [cosine] }) {
        const l = [Math.cos(light), Math.sin(light)];
        const at = ([x, y], t) => [x + t * l[0], y + t * l[1]];
        // Half of the beam, across it and on the floor.
        const half = 0.25;
        const foot = cosine > 0 ? half / cosine : 0;
        if (foot) {
            pen.path([[-foot, 0], at([-half * l[1], half * l[0]], 1.3), at([half * l[1], -half * l[0]], 1.3), [foot, 0]], 'b pale', true);
        }
        pen.line([-2, 0], [2, 0], 'ink');
        pen.line([-foot, 0], [foot, 0], 'b wide');
        pen.arrow([0, 0], [0, 1], 'c', 'n');
        pen.arrow([0, 0], at([0, 0], 0.9), 'b part-light');
        pen.text(at([0, 0], 0.8), 'l', 'b');
        if (cosine <= 0) {
            pen.text([0, 0.4], 'behind the floor: no light');
        }
    },
});
