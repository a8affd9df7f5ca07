// Lambert and Phong: the light that a point of the floor sends to each direction.
live.figure('shading', {
    below: 'phong-lobe.svg',
    title: 'Drag the light and the eye',
    hint: 'The curve is the brightness for an eye in each direction: the matt half circle, and the highlight’s lobe around the reflected light. Both reflectances are 0.5.',
    question: {
        text: 'The light moves down to the horizon. How does the height of the highlight’s lobe change?',
        choices: ['it shrinks with the cosine', 'it keeps its height'],
        right: 1,
        because: 'Lambert’s part has the factor n·l; Phong’s highlight has only (e·r) to the power p, and no cosine of the light.',
    },
    area: { x: [-1.5, 1.5], y: [-0.1, 1.45] },
    state: { light: 2.2, eye: 1.2, exponent: 16 },
    sliders: { exponent: { label: 'exponent', min: 1, max: 200, step: 1 } },
    handles: [
        live.angleHandle('the light', 'light', 1.2),
        live.angleHandle('the eye', 'eye', 1.2),
    ],
    values: { cosine: 'n·l', diffuse: 'matt', highlight: 'highlight', sum: 'sum' },
    draw(pen, { light, eye }, { lobe, reflected }) {
        const o = [0, 0];
        const at = (angle, length) => [length * Math.cos(angle), length * Math.sin(angle)];
        pen.line([-1.5, 0], [1.5, 0], 'ink');
        pen.path(lobe.map((sum, i) => at((Math.PI * i) / (lobe.length - 1), sum)), 'a pale', true);
        pen.arrow(o, [0, 1.1], 'c', 'n');
        pen.arrow(o, at(light, 1.1), 'b');
        pen.text(at(light, 1.28), 'light', 'b', 'middle');
        pen.arrow(o, reflected, 'thin part-cosine', 'r');
        pen.arrow(at(eye, 1.1), o, 'ink part-cosine');
        pen.text(at(eye, 1.28), 'eye', '', 'middle');
    },
});
