// The numbers of the scene file on the page: where they stand, and what the module says about them.
live.SceneNumbers = class {
    static units = ['length', 'degree', 'direction', 'factor', 'channel', 'whole'];

    constructor(editor) {
        this.editor = editor;
        // A module of its own, which no picture keeps busy.
        this.module = new live.Module();
    }

    // The picture as the file has it. Its camera is not turned.
    settings(changes) {
        return this.editor.picture.numbers({ yaw: 0, pitch: 0, zoom: 1, ...changes });
    }

    ask(request, numbers) {
        return this.module.ask(`${request} file\n${this.editor.text.value}`, numbers);
    }

    // All numbers of the text, in its order. They are asked for once for each text.
    async list() {
        const { text } = this.editor;
        if (this.listed?.text !== text.value) {
            const written = text.value;
            const { text: names, lines, starts, ends, values, units, least, greatest } = await this.ask('numbers', []);
            const numbers = names.split('\n').filter(Boolean).map((name, index) => {
                const [table, key] = name.split('\t');
                const [line, start, end, value] = [lines, starts, ends, values].map((list) => list[index]);
                const unit = live.SceneNumbers.units[units[index]];
                return { index, table, key, line, start, end, value, unit, least: least[index], greatest: greatest[index] };
            });
            this.listed = { text: written, numbers };
        }
        return this.listed.numbers;
    }

    // Writes another value of a number into the text.
    async write(index, value) {
        const { text } = this.editor;
        const numbers = await this.list();
        const { start, end } = numbers[index];
        const put = (literal) => (text.value = text.value.slice(0, start) + literal + text.value.slice(end));
        const digits = end - start;
        if (this.isHexadecimal(start)) {
            const largest = 16 ** digits - 1;
            put(Math.round(Math.min(Math.max(value, 0), 1) * largest).toString(16).padStart(digits, '0'));
        } else if (/["']/.test(text.value[start])) {
            // The name of a colour becomes a list of its channels.
            const channels = numbers.filter((number) => number.start === start);
            const list = channels.map((channel) => (channel.index === index ? value : channel.value));
            put(`[${list.map((channel) => Number(channel.toFixed(3))).join(', ')}]`);
        } else {
            put(String(value));
        }
        return this.list();
    }

    // Whether digits of a colour such as "#c0ffee" begin at a place of the text.
    isHexadecimal(start) {
        return /["']#[0-9a-f]*$/i.test(this.editor.text.value.slice(Math.max(start - 7, 0), start));
    }

    // The range of a slider for a number, around its value.
    range({ start, value, unit, least, greatest }) {
        if (unit === 'channel') {
            return { min: 0, max: Math.max(1, value), step: this.isHexadecimal(start) ? 1 / 255 : 0.01 };
        }
        const size = Math.abs(value);
        const reach = { degree: 45, factor: size, direction: Math.max(size, 0.5) }[unit] ?? Math.max(size / 2, 1);
        // A power of ten, or 2 or 5 times one.
        const step = live.roundStep(reach / 100);
        const inside = (x) => Math.min(Math.max(x, least + step), greatest - step);
        const [min, max] = [value - reach, value + reach].map((x) => Number(inside(x).toPrecision(4)));
        return { min, max, step };
    }
};

// The largest number of the form 1, 2 or 5 times a power of ten that is not above a number.
live.roundStep = (number) => {
    const power = 10 ** Math.floor(Math.log10(number));
    const digit = [5, 2, 1].find((digit) => digit * power <= number * 1.000001);
    return Number((digit * power).toPrecision(1));
};
