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
        this.drawn = live.svg('g', {});
        this.points = live.svg('g', { class: 'live-points' });
        this.line = live.svg('line', { class: 'live-wish' });
        this.words = live.svg('text', { 'text-anchor': 'end' });
        this.handle = live.svg('circle', {
            r: 12, class: 'live-handle', tabindex: 0, role: 'slider', 'aria-orientation': 'vertical',
            'aria-label': 'the error I want: arrow keys, with Shift in larger steps',
        });
        this.svg = live.svg('svg', { role: 'group', 'aria-label': 'error against time' });
        this.svg.append(this.drawn, this.line, this.points, this.words, this.handle);
        live.drag(this.handle, (event) => {
            const box = this.svg.getBoundingClientRect();
            this.want(this.pen.from([0, (event.clientY - box.top) * (live.Pen.width / box.width)])[1]);
        });
        live.keys(this.handle, live.arrows((right, up) => this.want(this.wanted + 0.02 * (right + up))));
    }

    // Places the line at the logarithm of an error.
    want(power) {
        const [low, high] = this.area.y;
        this.wanted = Math.min(Math.max(power, low), high);
        const y = this.pen.to([0, this.wanted])[1];
        const error = 10 ** this.wanted;
        const set = (shape, attributes) => Object.entries(attributes).forEach(([name, value]) => shape.setAttribute(name, value));
        set(this.line, { x1: 0, x2: live.Pen.width, y1: y, y2: y });
        set(this.words, { x: live.Pen.width - 46, y: y - 5 });
        this.words.textContent = `I want ${live.digits(error)}`;
        set(this.handle, { cx: live.Pen.width - 26, cy: y, 'aria-valuemin': 10 ** low, 'aria-valuemax': 10 ** high, 'aria-valuenow': error, 'aria-valuetext': live.digits(error) });
        this.wish(error);
    }

    // Draws the recorded curves thin, and the measured points: objects with `method`, `error`, `seconds` and
    // their ends. The axes hold all of them.
    draw(recorded, points) {
        const all = [...recorded, ...points];
        this.area = {
            x: live.WorkPrecision.range(all.map(({ seconds }) => seconds), 2.6, [1e-3, 1]),
            y: live.WorkPrecision.range([...all.map(({ error }) => error), 1 / 510], 1.6, [1e-4, 0.1]),
        };
        this.pen = new live.Pen(this.area);
        this.svg.setAttribute('viewBox', `0 0 ${live.Pen.width} ${this.pen.height}`);
        this.drawAxes();
        const { methods } = live.WorkPrecision;
        for (const [index, method] of methods.entries()) {
            const of = (list) => list.filter((point) => point.method === method && point.error > 0).map(live.WorkPrecision.place);
            for (const [list, kind] of [[recorded, 'recorded'], [points, '']]) {
                const places = of(list);
                if (places.length) {
                    this.pen.path(places, `m${index} ${kind}`);
                }
            }
        }
        this.drawn.innerHTML = this.pen.shapes.join('');
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

    drawAxes() {
        const { pen, area: { x, y } } = this;
        for (let power = Math.ceil(x[0]); power <= x[1]; power += 1) {
            pen.line([power, y[0]], [power, y[1]], 'grid');
            if (power < x[1] - 0.4) {
                pen.text([power, y[0]], live.time(10 ** power), 'axis');
            }
        }
        for (let power = Math.ceil(y[0]); power <= y[1]; power += 1) {
            pen.line([x[0], power], [x[1], power], 'grid');
            pen.text([x[0], power], `error ${10 ** power}`, 'axis');
        }
    }

    // A measured point with its intervals. It is larger on the front.
    mark(point, index) {
        const method = live.WorkPrecision.methods.indexOf(point.method);
        const [x, y] = this.pen.to(live.WorkPrecision.place({ ...point, error: point.error || 10 ** this.area.y[0] }));
        const across = [point.secondsLow, point.secondsHigh].map((end) => this.pen.to([Math.log10(end), 0])[0] - x);
        const along = [point.errorHigh, point.errorLow].map((end) => this.pen.to([0, Math.log10(Math.max(end, 10 ** this.area.y[0]))])[1] - y);
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
        live.keys(mark, { ArrowRight: () => go(1), ArrowDown: () => go(1), ArrowLeft: () => go(-1), ArrowUp: () => go(-1) });
        return mark;
    }
};

// Two digits, a number of things, and a time in its unit.
live.digits = (number) => String(Number(number.toPrecision(2)));
live.count = (number, thing) => `${live.digits(number)} ${thing}${number === 1 ? '' : 's'}`;
live.time = (seconds) => {
    const [unit, size] = [['s', 1], ['ms', 1e-3], ['µs', 1e-6], ['ns', 1e-9]].find(([, size]) => seconds >= 0.9995 * size) ?? ['ns', 1e-9];
    return `${live.digits(seconds / size)} ${unit}`;
};
