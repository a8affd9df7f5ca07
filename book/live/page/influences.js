// A pixel: the lines of the scene file that it changes with are marked in the text, and listed with
// the strongest first, each with sliders on its numbers.
live.Influences = class {
    // Lines of the list, and numbers of a request, for which another pixel waits.
    static most = 4;
    static together = 8;

    constructor(editor) {
        Object.assign(this, { editor, numbers: editor.numbers, pixel: undefined });
        this.places = ['column', 'row'].map((name, i) => {
            const change = ({ target }) => this.open(...Object.assign([...this.pixel], { [i]: Number(target.value) }));
            return live.element('input', { type: 'number', min: 0, 'aria-label': `${name} of the pixel`, onchange: change });
        });
        this.list = live.element('ol', { className: 'live-influences' });
        this.rest = live.element('p', { className: 'live-rest' });
        this.mark = live.element('span', { className: 'live-pixel' });
        const complain = ({ message }) => (editor.said.value = message);
        this.update = live.newest((isFirst) => this.answer(isFirst), complain);
        this.move = live.newest((slider, value) => this.slide(slider, value), complain);
        const buttons = [
            live.button('explain a pixel', () => editor.picture.explain(...this.pixel)),
            ' ',
            live.button('close', () => this.close()),
        ];
        const hint = 'Each number is moved to both sides, until things have moved by half a pixel; the list begins with what changes the pixel most. '
            + 'A slope is the change of linear light by 1, or by one degree of an angle. ± is what two steps, one twice the other, leave unsure. Drag a number, and see.';
        this.root = live.panel('Which number makes this pixel?', hint,
            live.div('live-controls', 'column ', this.places[0], ' row ', this.places[1]),
            this.list, this.rest, ...buttons);
        this.root.tabIndex = -1;
        live.keys(this.root, { Escape: () => this.close() });
    }

    // Shows the numbers of a pixel by its column and row.
    open(column, row) {
        const { picture } = this.editor;
        const { width, height, yaw, pitch, zoom } = picture.settings;
        if (yaw || pitch || zoom !== 1) {
            this.editor.said.value = 'The numbers are those of the camera in the file: press 0 in the picture, or reset, first.';
            return;
        }
        const inside = (place, side) => Math.min(Math.max(Math.floor(place) || 0, 0), side - 1);
        this.pixel = [inside(column, width), inside(row, height)];
        [width, height].forEach((side, i) => Object.assign(this.places[i], { value: this.pixel[i], max: side - 1 }));
        const percents = this.pixel.map((place, i) => `${((place + 0.5) / [width, height][i]) * 100}%`);
        Object.assign(this.mark.style, { left: percents[0], top: percents[1] });
        picture.frame.append(this.mark);
        if (!this.root.isConnected) {
            picture.frame.after(this.root);
        }
        return this.update(true);
    }

    close() {
        if (this.root.isConnected) {
            this.root.remove();
            this.mark.remove();
            this.editor.marks.show([]);
            this.pixel = undefined;
            this.editor.picture.frame.focus();
        }
    }

    // Asks for all numbers, some at a time; then shows the strongest, or, where the reader has
    // moved a slider, those that are shown already.
    async answer(isFirst) {
        const { editor, numbers, pixel } = this;
        const { value } = editor.text;
        const isOld = () => pixel !== this.pixel || value !== editor.text.value;
        const all = await numbers.list();
        const found = [];
        for (let first = 0; first < all.length; first += live.Influences.together) {
            if (!pixel || isOld()) {
                return;
            }
            if (isFirst) {
                this.rest.textContent = `asked ${first} of ${all.length} numbers …`;
            }
            // By one ray through the middle: with more of them, an answer would take seconds.
            const given = [...numbers.settings({ samples: 1, sampling: 0 }), ...pixel, first, live.Influences.together];
            const { kinds, changes, errors, places, strengths } = await numbers.ask('responses', given);
            kinds.forEach((kind, i) => {
                const change = changes.slice(3 * i, 3 * i + 3);
                found.push({ index: first + i, kind, change, error: errors[i], place: places[i], strength: strengths[i] });
            });
        }
        if (isOld()) {
            return;
        }
        const strongest = found.filter(({ kind }) => kind > 0).toSorted((a, b) => b.strength - a.strength);
        if (isFirst) {
            this.show(strongest, all);
        } else {
            this.sliders.forEach((slider) => slider.say(found[slider.index]));
        }
    }

    show(strongest, all) {
        // The lines in the order of their strongest numbers.
        this.lines = [...new Set(strongest.map(({ index }) => all[index].line))];
        const few = this.lines.slice(0, live.Influences.most);
        this.sliders = [];
        this.list.replaceChildren(...few.map((line) => this.item(strongest.filter(({ index }) => all[index].line === line), all)));
        const weaker = this.lines.length - few.length;
        // A whole number, such as that of copies, has no small step.
        const moved = all.filter(({ unit }) => unit !== 'whole').length;
        const others = moved - strongest.length;
        this.rest.textContent = `${weaker ? `${weaker} more lines change it less. ` : ''}${others} numbers do not change it.`;
        this.strongest = strongest;
        this.markLines(all);
        const [column, row] = this.pixel;
        const begin = `Pixel ${column}, ${row}: ${strongest.length} of ${moved} numbers change it.`;
        if (strongest.length === 0) {
            this.editor.said.value = begin;
            return;
        }
        const { line, key, table } = all[strongest[0].index];
        const words = live.Influences.words(strongest[0], all[strongest[0].index]);
        this.editor.said.value = `${begin} The strongest is ${key} of ${table} in line ${line}: ${words}.`;
        this.editor.reveal(line);
    }

    // The numbers that change the pixel, those of the strongest line brightest.
    markLines(all) {
        const ranges = this.strongest.map(({ index }) => {
            const { start, end, line } = all[index];
            return { start, end, strength: Math.max(1 - this.lines.indexOf(line) / live.Influences.most, 0.1) };
        });
        this.editor.marks.show(ranges);
    }

    // What a number does, in words.
    static words({ kind, change, error, place }, { unit }) {
        if (kind === 0) {
            return 'no change';
        }
        // A slope ends with the digit that is unsure, at the latest with the sixth one.
        const largest = Math.max(...change.map(Math.abs));
        const unsure = kind === 1 ? Math.max(error, 1e-6 * largest) : 0.01 * largest;
        const decimals = Math.min(Math.max(-Math.floor(Math.log10(unsure)), 0), 100);
        const [r, g, b] = change.map((x) => (x > 0 ? '+' : '') + live.show(Number(x.toFixed(decimals))));
        const named = [['red', r], ['green', g], ['blue', b]].filter(([, x]) => Number(x) !== 0);
        const channels = r === g && g === b ? r : named.map((part) => part.join(' ')).join(', ');
        if (kind === 2) {
            return `it jumps at ${live.show(place)}, by ${channels}`;
        }
        if (kind === 3) {
            return `no slope: at ${live.show(place)} it has changed by ${channels}`;
        }
        const most = Math.ceil(unsure * 10 ** decimals) / 10 ** decimals;
        return `${channels} ± ${live.show(most)} ${unit === 'degree' ? 'per degree' : 'per 1'}`;
    }

    // A line of the file, with sliders on its numbers.
    item(influences, all) {
        const numbers = influences.map(({ index }) => all[index]).toSorted((a, b) => a.index - b.index);
        const [{ index, line, table, key }] = numbers;
        const select = () => this.editor.select(this.numbers.listed.numbers[index]);
        const name = numbers.length > 1 ? key.replace(/ \S+$/, '') : key;
        const sliders = numbers.map((number) => {
            const influence = influences.find((influence) => influence.index === number.index);
            return this.slider(influence, number);
        });
        return live.element('li', {}, live.button(`line ${line}`, select), ` ${name} of ${table}`, ...sliders);
    }

    // A slider on a number, and what the number does.
    slider(influence, number) {
        const { index, line, table, key } = number;
        const range = { ...this.numbers.range(number), 'aria-label': `${key} of ${table}, line ${line}` };
        const control = live.control(key.split(' ').at(-1), range, (value) => this.move({ index, control }, value));
        control.show(number.value, live.show(number.value));
        const words = live.element('span', {}, live.Influences.words(influence, number));
        this.sliders.push({ index, say: (now) => (words.textContent = live.Influences.words(now, number)) });
        return live.div('live-controls', control.element, ' ', words);
    }

    // A slider has moved: another number in the text, another picture, and other changes.
    async slide({ index, control }, value) {
        const all = await this.numbers.write(index, value);
        control.show(value, live.show(all[index].value));
        this.markLines(all);
        await this.editor.slide();
    }
};
