// Light on a surface: as a number without limit, limited at once, and in whole numbers.
live.figure('color', {
    below: 'light-and-bytes.svg',
    title: 'Light on three balls',
    hint: 'The same light on the same matt balls, whose products are ours, by Color; limited to 1 before the product, as in the program behind the protocol; and of bytes, as in the protocol’s text. The ray goes from the lamp to the brightest point and on to the eye. The last number is the byte of our product without rounding, by a cast.',
    question: {
        text: 'Two lamps of brightness 1 light a surface that sends back one half. A program that limits light to 1 at once paints it…',
        choices: ['as bright as it is', 'half as bright', 'a third as bright'],
        right: 1,
        because: 'the light is 2, and half of it is 1, the byte 255. Limited to 1 before the product, one half is left, the byte 128.',
    },
    over: true,
    picture: [438, 146],
    area: { x: [0, 3], y: [0, 1] },
    state: { light: 3, fraction: 0.25 },
    sliders: {
        light: { label: 'light that arrives', min: 0, max: 4, step: 0.05 },
        fraction: { label: 'fraction sent back', min: 0, max: 1, step: 0.01 },
    },
    values: { product: 'light, ours', byte: 'byte', clamped: 'limited at once', clamped_byte: 'byte', whole: 'whole numbers', whole_byte: 'byte', cut_byte: 'ours, cut off instead of rounded' },
    draw(pen, { light }, { product, byte, clamped, clamped_byte, whole, whole_byte }) {
        const short = (x) => live.show(Number(x.toPrecision(3)));
        [['ours', product, byte], ['limited', clamped, clamped_byte], ['bytes', whole, whole_byte]].forEach(([name, [sent], [byte]], i) => {
            const [lamp, point, eye] = [[i + 0.04, 0.98], [i + 0.34, 0.74], [i + 0.96, 0.62]];
            pen.arrow(lamp, point, 'b');
            pen.arrow(point, eye, 'b');
            pen.text([i + 0.14, 0.8], short(light), 'b');
            pen.text([i + 0.98, 0.64], short(sent), 'b', 'end');
            pen.text([i + 0.03, 0.0], name);
            pen.text([i + 0.98, 0.0], `${byte}`, '', 'end');
        });
    },
});
