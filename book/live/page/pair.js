// Pictures of the errata, and of the cracks: the wrong panel over the right one, with a
// slider between them. The picture holds both side by side, with a gap.
live.Pair = class {
    static gap = 8;

    constructor(image, after) {
        this.image = image;
        this.canvas = live.element('canvas', { role: 'img', 'aria-label': image.alt });
        const label = 'how much of the wrong picture lies over the right one';
        this.slider = live.element('input', { type: 'range', min: 0, max: 100, value: 50, 'aria-label': label, oninput: () => this.draw() });
        const row = live.element('label', {}, 'left of the line wrong ', this.slider, ' right of it as it should be');
        after.after(live.element('figure', { className: 'live-pair' }, this.canvas, row));
        image.decode().then(() => this.draw(), () => {});
        live.stillOf(image);
    }

    draw() {
        const { canvas, image } = this;
        const width = (image.naturalWidth - live.Pair.gap) / 2;
        const height = image.naturalHeight;
        Object.assign(canvas, { width, height });
        const context = canvas.getContext('2d');
        context.drawImage(image, width + live.Pair.gap, 0, width, height, 0, 0, width, height);
        const shown = Math.round((width * this.slider.value) / 100);
        if (shown) {
            context.drawImage(image, 0, 0, shown, height, 0, 0, shown, height);
        }
        context.fillStyle = '#fff';
        context.fillRect(shown - 1, 0, 2, height);
    }
};

live.pairs = live.images(':is(img[src*="/errata-"], img[src$="/go-wrong-cracks.png"])')
    .map((image) => new live.Pair(image, live.caption(image)));
