// Light on a surface: as a number without limit, limited at once, and in whole numbers.
live.figure('color', {
    below: 'light-and-bytes.svg',
    title: 'Light on a surface',
    hint: 'Three greys of the same light on the same surface: by Color, limited to 1 before the product as in the program behind the protocol, and as a product of bytes as in the protocol’s text. The last number is the byte of our product without rounding, by a cast.',
    question: {
        text: 'Two lamps of brightness 1 light a surface that sends back one half. A program that limits light to 1 at once paints it…',
        choices: ['as bright as it is', 'half as bright', 'a third as bright'],
        right: 1,
        because: 'the light is 2, and half of it is 1, the byte 255. Limited to 1 before the product, one half is left, the byte 128.',
    },
    area: { x: [0, 3], y: [-0.05, 0.85] },
    state: { light: 3, share: 0.25 },
    sliders: {
        light: { label: 'light that arrives', min: 0, max: 4, step: 0.05 },
        share: { label: 'share sent back', min: 0, max: 1, step: 0.01 },
    },
    values: { product: 'light, ours', byte: 'byte', clamped: 'limited at once', clamped_byte: 'byte', whole: 'whole numbers', whole_byte: 'byte', cut_byte: 'ours, cut off instead of rounded' },
    draw(pen, _, { byte, clamped_byte, whole_byte }) {
        [['ours', byte], ['limited at once', clamped_byte], ['whole numbers', whole_byte]].forEach(([name, [grey]], i) => {
            const [x, y] = pen.to([i + 0.1, 0.5]);
            pen.shapes.push(`<rect style="fill: rgb(${grey} ${grey} ${grey})" x="${x}" y="${y}" width="${0.8 * pen.scale}" height="${0.5 * pen.scale}"/>`);
            pen.text([i + 0.5, 0.52], name, '', 'middle');
        });
    },
});
