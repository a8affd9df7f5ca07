// The cursor in a line of the scene file: the pixels that change with the line's numbers light up in
// the picture. The next key stops the search.
live.Dependents = class {
    // Pixels of the largest map: those of 320 × 240.
    static most = 320 * 240;

    constructor(editor) {
        Object.assign(this, { editor, numbers: editor.numbers });
        this.canvas = live.element('canvas', { className: 'live-dependents', ariaHidden: 'true' });
        this.update = live.newest(() => this.search(), ({ message }) => (this.editor.said.value = message));
        const { text } = editor;
        document.addEventListener('selectionchange', () => this.moved(), true);
        text.addEventListener('focus', () => this.moved());
        text.addEventListener('blur', () => this.hide());
    }

    // The line of the cursor, from 1.
    get place() {
        const { text } = this.editor;
        return text.value.slice(0, text.selectionStart).split('\n').length;
    }

    // The cursor has moved, or the text has changed, whose picture may not be there yet.
    moved() {
        const { text, drawn, light } = this.editor;
        if (document.activeElement !== text || text.value !== drawn || !light.checked) {
            return this.hide();
        }
        if (this.place !== this.line) {
            this.line = this.place;
            this.start();
        }
    }

    hide() {
        this.line = undefined;
        this.search_number = (this.search_number ?? 0) + 1;
        this.canvas.remove();
    }

    async start() {
        this.search_number = (this.search_number ?? 0) + 1;
        this.began = performance.now();
        this.lit = undefined;
        // A request is one picture, which is soon there, but not in a scene of many mirrors.
        if (this.asked && performance.now() - this.asked > 100) {
            await this.numbers.module.stop('stopped: the cursor has moved');
        }
        await this.update();
    }

    // Makes the picture, with which others are compared, before the cursor comes. A text that the
    // reader breaks meanwhile needs none.
    async prepare() {
        if (this.editor.light.checked) {
            await this.numbers.ask('changes', this.sizes().at(-1).settings).catch(() => {});
        }
    }

    // The sizes of the maps. One at half the width and height takes a quarter of the time, and comes
    // first where the whole one lets the reader wait.
    sizes() {
        const { width, height } = this.editor.picture.settings;
        const shrunk = Math.max(1, Math.sqrt((width * height) / live.Dependents.most));
        return (this.isSlow ? [2, 1] : [1]).map((factor) => {
            const [w, h] = [width, height].map((side) => Math.max(1, Math.round(side / shrunk / factor)));
            return { size: [w, h], settings: this.numbers.settings({ width: w, height: h, samples: 1, sampling: 0 }) };
        });
    }

    async search() {
        const { editor, numbers, line, search_number } = this;
        const isOld = () => search_number !== this.search_number || line === undefined;
        const all = await numbers.list();
        const found = all.filter((number) => number.line === line && number.unit !== 'whole');
        if (isOld()) {
            return;
        }
        if (found.length === 0) {
            this.canvas.remove();
            editor.said.value = `Line ${line} has no numbers that can be moved.`;
            return;
        }
        let strengths;
        let last;
        for (const { size, settings } of this.sizes()) {
            strengths = new Uint8Array(size[0] * size[1]);
            last = size;
            for (const { index } of found) {
                this.asked = performance.now();
                const { pixels } = await numbers.ask('changes', [...settings, index]);
                this.asked = undefined;
                if (isOld()) {
                    return;
                }
                for (let i = 0; 4 * i < pixels.length; i += 1) {
                    strengths[i] = Math.max(strengths[i], pixels[4 * i + 3]);
                }
            }
            this.paint(strengths, size);
            this.lit ??= performance.now() - this.began;
        }
        this.milliseconds = performance.now() - this.began;
        this.isSlow = this.milliseconds > 100;
        this.say(found, strengths, last);
    }

    // Orange over the pixels that change, the stronger the more, and a shade over the others.
    paint(strengths, size) {
        const largest = strengths.reduce((a, b) => Math.max(a, b), 0);
        const pixels = new Uint8ClampedArray(4 * strengths.length);
        strengths.forEach((strength, i) => {
            const heat = strength && Math.max(1 - (largest - strength) / 254, 0.25);
            pixels.set(strength ? [255, 150, 0, 60 + 150 * heat] : [0, 0, 0, 165], 4 * i);
        });
        live.paint(this.canvas, { size, pixels });
        if (!this.canvas.isConnected) {
            this.editor.picture.frame.append(this.canvas);
        }
    }

    say(found, strengths, [width]) {
        const [{ line, table, key }] = found;
        const name = found.length > 1 ? key.replace(/ \S+$/, '') : key;
        const of = found.every((number) => number.table === table) ? `, ${name} of ${table}` : '';
        const count = strengths.reduce((sum, strength) => sum + (strength > 0), 0);
        const many = (number) => number.toLocaleString('en');
        const share = `${many(count)} of ${many(strengths.length)} pixels`;
        const strongest = strengths.indexOf(strengths.reduce((a, b) => Math.max(a, b), 0));
        const scale = this.editor.picture.settings.width / width;
        const [column, row] = [strongest % width, Math.floor(strongest / width)].map((place) => Math.floor((place + 0.5) * scale));
        const most = count ? ` Most of all: column ${column}, row ${row}.` : '';
        this.editor.said.value = `Line ${line}${of}: ${share} change with it.${most}`;
    }
};
