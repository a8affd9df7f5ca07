// Figures that answer: a drawing with handles to drag, sliders and numbers. A figure is
// a description, shown below the diagram of the book that it belongs to:
//
//     live.figure('sphere', {
//         below: 'sphere-quadratic',           the diagram's file
//         title, hint,                         headings: an action, and explanations
//         question: { text, choices, right, because },   comes before the numbers
//         area: { x: [-3, 3], y: [-2, 2] },    the visible part; y is upwards
//         state: { x: 0, y: 0.5 },             the numbers, in the module's order
//         sliders: { x: { label, min, max, step } },
//         handles: [{ label, at(state), move(state, x, y) }],   or live.follow
//         values: { 'ours.0': 't₀, ours' },    numbers of the answer that are shown
//         draw(pen, state, answer),
//     });
//
// `picture` is the size of a picture that the module answers; with `over`, the drawing
// lies over it. A figure whose state has `yaw` and `pitch` turns. One that `grows` is a
// list of rows, `[page, heading, title, hint, more]`: it stands at the end of each of these
// sections, with the row's number as `step` of its state; the other numbers are common.
// `numbers` says how many of the state the module takes, if not all.
//
// The numbers come from the module alone: the code of the stages.
live.figures = {};

// Collects the shapes of a drawing, in the coordinates of the figure.
live.Pen = class {
    static width = 440;

    constructor({ x, y }) {
        this.area = { x, y };
        this.scale = live.Pen.width / (x[1] - x[0]);
        this.height = (y[1] - y[0]) * this.scale;
        this.shapes = [];
    }

    to([x, y]) {
        return [(x - this.area.x[0]) * this.scale, (this.area.y[1] - y) * this.scale];
    }

    from([x, y]) {
        return [x / this.scale + this.area.x[0], this.area.y[1] - y / this.scale];
    }

    path(points, kind, closed = false) {
        const places = points.map((point) => this.to(point).map((x) => x.toFixed(2)).join(' '));
        this.shapes.push(`<path class="${kind}" d="M${places.join('L')}${closed ? 'Z' : ''}"/>`);
    }

    line(from, to, kind) {
        this.path([from, to], kind);
    }

    // An arrow of a fixed head, so that short vectors are seen, and its name at the tip.
    arrow(from, to, kind, name = '', anchor = 'start') {
        const [x, y] = [to[0] - from[0], to[1] - from[1]];
        const length = Math.hypot(x, y);
        if (length > 0) {
            this.line(from, to, kind);
            const head = 9 / this.scale / length;
            const side = (s) => [to[0] - head * (x + s * y * 0.5), to[1] - head * (y - s * x * 0.5)];
            this.path([side(1), to, side(-1)], kind);
        }
        this.text(to, name, kind.replace(/ink|thin/, ''), anchor);
    }

    circle(centre, radius, kind) {
        const [x, y] = this.to(centre);
        this.shapes.push(`<circle class="${kind}" cx="${x}" cy="${y}" r="${radius * this.scale}"/>`);
    }

    dot(at, kind, radius = 4) {
        this.circle(at, radius / this.scale, `${kind} live-dot`);
    }

    text(at, words, kind = '', anchor = 'start') {
        const [x, y] = this.to(at);
        const place = `text-anchor="${anchor}" x="${x + (anchor === 'start' ? 9 : 0)}" y="${y - 11}"`;
        this.shapes.push(words && `<text class="${kind}" ${place}>${words}</text>`);
    }
};

live.Figure = class {
    constructor(name, figure, after, together = []) {
        Object.assign(this, { name, figure, together });
        together.push(this);
        this.state = { ...figure.state };
        this.change = live.newest(() => this.answer(), ({ message }) => (this.root.dataset.error = message));
        this.root = live.panel(figure.title, figure.hint, this.makeQuestion(), this.makeDrawings(), this.makeSliders(), this.makeValues());
        this.root.toggleAttribute('data-asked', Boolean(figure.question));
        after.after(this.root);
        this.isStale = true;
        // The module is loaded when the reader is about to see a figure.
        new IntersectionObserver(([entry]) => {
            this.isSeen = entry.isIntersecting;
            if (this.isSeen && this.isStale) {
                this.change();
            }
        }, { rootMargin: '100%' }).observe(this.root);
    }

    // A prediction first: the numbers show once the reader has chosen.
    makeQuestion() {
        const { question } = this.figure;
        if (!question) {
            return '';
        }
        const verdict = live.element('output');
        const buttons = question.choices.map((choice, index) => {
            const choose = () => {
                delete this.root.dataset.asked;
                buttons.forEach((button) => (button.disabled = true));
                buttons[index].classList.add('live-chosen');
                verdict.value = `${index === question.right ? 'Yes:' : 'No:'} ${question.because}`;
            };
            return live.button(choice, choose);
        });
        return live.element('div', { className: 'live-question' }, question.text, ' ', ...buttons, verdict);
    }

    makeDrawings() {
        const { area, picture, over } = this.figure;
        const drawings = live.element('div', { className: over ? 'live-drawings live-over' : 'live-drawings' });
        this.area = area;
        this.drawn = live.svg('g', {});
        const box = `0 0 ${live.Pen.width} ${new live.Pen(area).height}`;
        this.svg = live.svg('svg', { viewBox: box, role: 'group', 'aria-label': this.figure.title }, this.drawn);
        drawings.append(this.svg);
        if ('yaw' in this.figure.state) {
            this.turnBy(this.svg);
        }
        this.handles = (this.figure.handles ?? []).map((handle) => this.addHandle(handle));
        if (picture) {
            this.canvas = live.element('canvas', { width: picture[0], height: picture[1] });
            over ? drawings.prepend(this.canvas) : drawings.append(this.canvas);
        }
        return drawings;
    }

    addHandle(handle) {
        const [least, most] = this.area.x;
        const circle = live.svg('circle', {
            r: 12,
            class: 'live-handle',
            tabindex: 0,
            role: 'slider',
            'aria-label': `${handle.label}: arrow keys, with Shift in larger steps; Home and End`,
            'aria-valuemin': least,
            'aria-valuemax': most,
            'aria-valuenow': least,
        });
        const move = (x, y) => this.set(handle.move(this.state, x, y));
        live.drag(circle, (event) => {
            const box = this.svg.getBoundingClientRect();
            const shrunk = live.Pen.width / box.width;
            const place = [(event.clientX - box.left) * shrunk, (event.clientY - box.top) * shrunk];
            move(...this.inside(new live.Pen(this.area).from(place)));
        });
        const step = (most - least) / 60;
        const height = () => handle.at(this.state)[1];
        live.keys(circle, {
            ...live.arrows((right, up) => {
                const [x, y] = handle.at(this.state);
                move(...this.inside([x + right * step, y + up * step]));
            }),
            Home: () => move(least, height()),
            End: () => move(most, height()),
        });
        this.svg.append(circle);
        return { ...handle, circle };
    }

    // A drag beside the handles, or arrow keys, turn the view of a figure.
    turnBy(svg) {
        const turn = (right, up) => this.set({
            yaw: this.state.yaw - right,
            pitch: Math.min(Math.max(this.state.pitch - up, 0.05), 1.5),
        });
        svg.setAttribute('tabindex', 0);
        svg.setAttribute('aria-label', `${this.figure.title}. Arrow keys turn.`);
        svg.classList.add('live-turns');
        live.drag(svg, (_, right, down) => turn(right * 0.01, -down * 0.01));
        live.keys(svg, live.arrows((right, up) => turn(right * 0.1, up * 0.1)));
    }

    inside([x, y]) {
        const limit = ([low, high], value) => Math.min(Math.max(value, low), high);
        return [limit(this.area.x, x), limit(this.area.y, y)];
    }

    makeSliders() {
        const sliders = live.element('div', { className: 'live-controls' });
        this.sliders = Object.entries(this.figure.sliders ?? {}).map(([name, { label, ...range }]) => {
            const control = live.control(label, range, (value) => this.set({ [name]: value }));
            sliders.append(control.element);
            return () => control.show(this.state[name], live.show(this.state[name]));
        });
        return sliders;
    }

    makeValues() {
        const table = live.element('div', { className: 'live-values' });
        this.values = Object.entries(this.figure.values ?? {}).map(([name, label]) => {
            const value = live.element('output');
            table.append(live.element('span', {}, `${label} `, value));
            return [name, value];
        });
        return table;
    }

    // Changes numbers of the state; resolves once they are answered and drawn.
    set(numbers) {
        // A large picture is rendered small at once and in full when the reader pauses.
        if ('coarse' in this.state && !('coarse' in numbers)) {
            numbers.coarse = 2;
            clearTimeout(this.pause);
            this.pause = setTimeout(() => this.set({ coarse: 1 }), 250);
        }
        for (const figure of this.together) {
            const { step } = figure.state;
            Object.assign(figure.state, numbers, step === undefined ? {} : { step });
            figure.isStale = true;
            if (figure !== this && figure.isSeen) {
                figure.change();
            }
        }
        return this.change();
    }

    // The state in a sentence, for a screen reader: where the handle is, and what the figure says.
    describe([x, y]) {
        const numbers = [...this.root.querySelectorAll('.live-values > span')].map((value) => value.textContent);
        const known = 'asked' in this.root.dataset ? [] : numbers;
        return [`at ${live.show(x)}, ${live.show(y)}`, ...known].join('; ');
    }

    async answer() {
        this.isStale = false;
        const answer = await live.ask(this.name, Object.values(this.state).slice(0, this.figure.numbers));
        // Some figures need a second answer.
        const more = await this.figure.more?.(this.state);
        this.show({ ...more, ...answer });
        delete this.root.dataset.error;
    }

    show(answer) {
        this.sliders.forEach((show) => show());
        for (const [name, element] of this.values) {
            const [list, index = 0] = name.split('.');
            element.value = live.show(answer[list]?.[index]);
        }
        const pen = new live.Pen(this.area);
        this.figure.draw(pen, this.state, answer);
        this.drawn.innerHTML = pen.shapes.join('');
        for (const { circle, at } of this.handles) {
            const place = at(this.state);
            circle.setAttribute('transform', `translate(${pen.to(place)})`);
            circle.setAttribute('aria-valuenow', live.show(place[0]));
            circle.setAttribute('aria-valuetext', this.describe(place));
        }
        if (this.canvas) {
            live.paint(this.canvas, answer);
        }
        this.root.dataset.drawn = (Number(this.root.dataset.drawn) || 0) + 1;
    }
};

// Shows a figure on the page that has its diagram, behind the diagram's caption; or one that
// grows, at the end of its sections.
live.figure = (name, figure) => {
    if (!live.works) {
        return;
    }
    const image = figure.below && document.querySelector(`main img[src$="${figure.below}"]`);
    if (image) {
        live.figures[name] = new live.Figure(name, figure, live.caption(image));
    }
    const together = [];
    (figure.grows ?? []).forEach(([page, heading, title, hint, more], step) => {
        let last = location.pathname.includes(page) && document.querySelector(`main > h2#${heading}`);
        while (last?.nextElementSibling && !last.nextElementSibling.matches('h2, details.fold')) {
            last = last.nextElementSibling;
        }
        if (last) {
            const row = { ...figure, title, hint, ...more, state: { ...figure.state, ...more?.state, step } };
            live.figures[`${name}-${step}`] = new live.Figure(name, row, last, together);
        }
    });
};

// Space on the page: a parallel view of a point, turned by the yaw and the pitch of a state.
live.flat = ({ yaw, pitch }, [x, y, z]) => {
    const [sine, cosine] = [Math.sin(yaw), Math.cos(yaw)];
    return [cosine * x - sine * z, Math.cos(pitch) * y - Math.sin(pitch) * (sine * x + cosine * z)];
};

// A list of coordinates as points of space.
live.points = (list = []) => Array.from({ length: list.length / 3 }, (_, i) => list.slice(3 * i, 3 * i + 3));

// A handle for two numbers of the state.
live.handle = (label, x, y) => ({
    label,
    at: (state) => [state[x], state[y]],
    move: (_, ...place) => ({ [x]: place[0], [y]: place[1] }),
});

// A handle on a circle around a point, for an angle of the state, in radians.
live.angleHandle = (label, name, radius, centre = () => [0, 0]) => ({
    label,
    at: (state) => {
        const [x, y] = centre(state);
        return [x + radius * Math.cos(state[name]), y + radius * Math.sin(state[name])];
    },
    move: (state, x, y) => {
        const [cx, cy] = centre(state);
        return { [name]: Math.atan2(y - cy, x - cx) };
    },
});
