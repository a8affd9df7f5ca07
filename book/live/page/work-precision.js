// A work-precision diagram: error against time on logarithmic axes, with points to look at by mouse or
// keyboard, and a line of an error to drag.
live.WorkPrecision = class {
    // Each method has its colour and its mark, everywhere on the page.
    // As in the recorded diagrams: random is blue and a circle.
    static methods = ['one in the middle', 'random', 'regular', 'stratified', 'adaptive', 'n rooks', 'R2'];
    static marks = ['M-5 0H5M0-5V5', 'M-4 0A4 4 0 1 0 4 0A4 4 0 1 0-4 0Z', 'M-4-4H4V4H-4Z', 'M0-5L5 4H-5Z', 'M0-5L5 0L0 5L-5 0Z', 'M-4-4L4 4M-4 4L4-4', 'M0 5L5-4H-5Z'];

    static key(method) {
        const index = live.WorkPrecision.methods.indexOf(method);
        const svg = live.svg('svg', { viewBox: '-7 -7 14 14', class: 'live-key', 'aria-hidden': true });
        svg.append(live.svg('path', { class: `m${index} mark`, d: live.WorkPrecision.marks[index] }));
        return svg;
    }

    // `look` is called with a point that is pointed at, and `wish` with an error while its line is dragged.
    constructor(look, wish) {
        this.look = look;
        this.wish = wish;
        this.area = { x: [0, 1], y: [0, 1] };
        this.drawing = new live.Drawing(this.area, 'error against time');
        this.svg = this.drawing.svg;
        this.points = live.svg('g', { class: 'live-points' });
        this.line = live.svg('path', { class: 'live-wish', d: `M0 0H${live.Pen.width}` });
        this.words = live.svg('text', { 'text-anchor': 'end', y: -5 });
        this.svg.append(this.line, this.points, this.words);
        this.handle = this.drawing.handle({
            tabindex: 0, role: 'slider', 'aria-orientation': 'vertical',
            'aria-label': 'the error I want: arrow keys, with Shift in larger steps',
        }, ([, power]) => this.want(power));
        live.keys(this.handle, live.arrows((right, up) => this.want(this.wanted + 0.02 * (right + up))));
    }

    // Places the line at the logarithm of an error, above the words of the times, which its handle would cover.
    want(power) {
        const { scale } = this.drawing.pen;
        const [low, high] = [this.area.y[0] + 50 / scale, this.area.y[1]];
        this.wanted = Math.min(Math.max(power, low), high);
        const error = 10 ** this.wanted;
        const [left, right] = this.area.x;
        this.drawing.place(this.line, [left, this.wanted]);
        this.drawing.place(this.words, [right - 54 / scale, this.wanted]);
        this.drawing.place(this.handle, [right - 26 / scale, this.wanted]);
        this.words.textContent = `I want ${live.digits(error)}`;
        const said = { 'aria-valuemin': 10 ** low, 'aria-valuemax': 10 ** high, 'aria-valuenow': error, 'aria-valuetext': live.digits(error) };
        Object.entries(said).forEach(([name, value]) => this.handle.setAttribute(name, value));
        this.wish(error);
    }

    // Draws the recorded curves thin, and the measured points: objects with `method`, `error`, `seconds` and
    // their ends. The axes hold all of them.
    draw(recorded, points) {
        const all = [...recorded, ...points];
        const [low, high] = live.WorkPrecision.range([...all.map(({ error }) => error), 1 / 510], 1.6, [1e-4, 0.1]);
        // Wider than high, for a phone.
        const x = live.WorkPrecision.range(all.map(({ seconds }) => seconds), Math.max(2.6, 1.4 * (high - low)), [1e-3, 1]);
        // Below all that may be wanted there is room for the words of the times.
        this.area = { x, y: [low + 0.15 - 50 * (x[1] - x[0]) / live.Pen.width, high] };
        const pen = new live.Pen(this.area);
        const powers = ([low, high]) => Array.from({ length: Math.floor(high) - Math.ceil(low) + 1 }, (_, index) => Math.ceil(low) + index);
        const { methods } = live.WorkPrecision;
        for (const [index, method] of methods.entries()) {
            const of = (list) => list.filter((point) => point.method === method && point.error > 0).map(live.WorkPrecision.place);
            for (const [list, kind] of [[recorded, 'recorded'], [points, '']]) {
                const places = of(list);
                if (places.length > 1) {
                    pen.path(places, `m${index} ${kind}`);
                } else if (places.length && kind) {
                    pen.dot(places[0], `m${index}`);
                }
            }
        }
        // Over the curves.
        pen.grid(0, powers(x).map((power) => [power, power < x[1] - 0.4 && live.time(10 ** power)]));
        pen.grid(1, powers([low + 0.15, high]).map((power) => [power, power < high - 0.25 && `error ${10 ** power}`]));
        this.drawing.show(pen);
        const focused = [...this.points.children].indexOf(document.activeElement);
        this.points.replaceChildren(...points.map((point, index) => this.mark(point, index)));
        const first = this.points.children[Math.max(focused, 0)];
        first?.setAttribute('tabindex', 0);
        if (focused >= 0) {
            this.isDrawing = true;
            first?.focus();
            this.isDrawing = false;
        }
        this.want(this.wanted ?? Math.log10(1 / 510));
    }

    // Whole powers of ten, and a range that is not too short.
    static range(numbers, least, otherwise) {
        const logs = (numbers.some((number) => number > 0) ? numbers : otherwise).filter((number) => number > 0).map(Math.log10);
        const [low, high] = [Math.min(...logs) - 0.15, Math.max(...logs) + 0.15];
        const more = Math.max(least - (high - low), 0) / 2;
        return [low - more, high + more];
    }

    static place({ seconds, error }) {
        return [Math.log10(seconds), Math.log10(error)];
    }

    // A measured point with its intervals. It is larger on the front.
    mark(point, index) {
        const method = live.WorkPrecision.methods.indexOf(point.method);
        const { pen } = this.drawing;
        const least = 10 ** this.area.y[0];
        const at = ([seconds, error]) => pen.to([Math.log10(seconds), Math.log10(Math.max(error, least))]);
        const [x, y] = at([point.seconds, point.error]);
        const across = [point.seconds_low, point.seconds_high].map((end) => at([end, 1])[0] - x);
        const along = [point.error_high, point.error_low].map((end) => at([1, end])[1] - y);
        const shapes = [
            live.svg('circle', { r: 12, class: 'live-reach' }),
            live.svg('path', { class: `m${method}`, d: `M${across[0]} 0H${across[1]}M0 ${along[0]}V${along[1]}` }),
            live.svg('path', { class: `m${method} mark${point.front ? ' front' : ''}`, d: live.WorkPrecision.marks[method] }),
        ];
        const mark = live.svg('g', { transform: `translate(${x} ${y})`, tabindex: -1, role: 'img', 'aria-label': point.words }, ...shapes);
        const look = () => this.isDrawing || this.look(point);
        mark.addEventListener('pointerenter', look);
        mark.addEventListener('focus', look);
        const go = (step) => {
            const marks = [...this.points.children];
            const next = marks[(index + step + marks.length) % marks.length];
            mark.setAttribute('tabindex', -1);
            next.setAttribute('tabindex', 0);
            next.focus();
        };
        live.keys(mark, live.arrows((right, up) => go(Math.sign(right - up))));
        return mark;
    }
};

// Two digits, a number of things, of which a whole one has all digits, and a time in its unit.
live.digits = (number) => String(Number(number.toPrecision(2)));
live.count = (number, thing) => `${Number.isInteger(number) ? number : live.digits(number)} ${thing}${number === 1 ? '' : 's'}`;
live.time = (seconds) => {
    const [unit, size] = [['s', 1], ['ms', 1e-3], ['µs', 1e-6], ['ns', 1e-9]].find(([, size]) => seconds >= 0.9995 * size) ?? ['ns', 1e-9];
    return `${live.digits(seconds / size)} ${unit}`;
};
