// Small angles, by the arc tangent and by the arc cosine.
live.figure('angle', {
    below: 'cosine-flat.svg',
    title: 'Make the angle smaller',
    hint: 'The angle between (1, 0, 0) and (1, t, 0). The curve is the relative error of the arc cosine, on logarithmic axes; the dots are the errors at this t, of the arc cosine above and of the arc tangent below. An error of 0 is drawn at the lowest line.',
    question: {
        text: 'For t = 10⁻⁹, which angle does the arc cosine find?',
        choices: ['10⁻⁹', '0', 'NaN'],
        right: 1,
        because: 'the cosine differs from 1 by half of t², which is 5 · 10⁻¹⁹. The numbers just below 1 lie 10⁻¹⁶ apart, so the cosine rounds to 1, and the arc cosine of 1 is 0.',
    },
    area: { x: [-14, 0.5], y: [-7.2, 0.7] },
    state: { power: -3 },
    sliders: { power: { label: 't: 10 to the', min: -12, max: 0, step: 0.25 } },
    values: { tangent: 't', ours: 'angle, by the arc tangent', by_cosine: 'by the arc cosine', our_error: 'relative error of the arc tangent', cosine_error: 'of the arc cosine' },
    draw(pen, { power }, { powers, errors, our_error, cosine_error }) {
        // Powers of ten upwards are drawn smaller than to the right.
        const log = (error) => Math.log10(Math.max(error, 1e-17)) / 2.5;
        [1, 1e-8, 1e-16].forEach((error, i) => {
            pen.line([-12, log(error)], [0, log(error)], 'thin');
            pen.text([-12.2, log(error) - 0.5], ['1', '10⁻⁸', '10⁻¹⁶'][i], '', 'end');
        });
        pen.line([-12, log(0)], [0, log(0)], 'ink');
        pen.path(powers.map((power, i) => [power, log(errors[i])]), 'b');
        pen.dot([power, log(cosine_error[0])], 'b', 6);
        pen.dot([power, log(our_error[0])], 'c', 6);
        pen.text([-5.4, -1.4], 'arc cosine', 'b');
        pen.text([-5.4, -6.1], 'arc tangent', 'c');
    },
});
