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

live.Figure = class {
    constructor(name, figure, after, together = []) {
        Object.assign(this, { name, figure, together });
        together.push(this);
        this.state = { ...figure.state };
        this.change = live.newest(() => this.answer(), live.failure(this));
        this.root = live.panel(figure.title, figure.hint, this.makeQuestion(), this.makeDrawings(), this.makeSliders(), this.makeValues());
        this.root.toggleAttribute('data-asked', Boolean(figure.question));
        after.after(this.root);
        this.isStale = true;
        live.seen(this.root, (isSeen) => {
            this.isSeen = isSeen;
            if (isSeen && this.isStale) {
                this.change();
            }
        });
    }

    // A prediction first: the numbers show once the reader has chosen.
    makeQuestion() {
        const { question } = this.figure;
        if (!question) {
            return '';
        }
        return live.question(question.text, question.choices, (index) => {
            delete this.root.dataset.asked;
            return `${index === question.right ? 'Yes:' : 'No:'} ${question.because}`;
        });
    }

    makeDrawings() {
        const { area, picture, over } = this.figure;
        const drawings = live.element('div', { className: over ? 'live-drawings live-over' : 'live-drawings' });
        this.area = area;
        this.drawing = new live.Drawing(area, this.figure.title);
        this.svg = this.drawing.svg;
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
        const move = (x, y) => this.set(handle.move(this.state, x, y));
        const circle = this.drawing.handle({
            tabindex: 0,
            role: 'slider',
            'aria-label': `${handle.label}: arrow keys, with Shift in larger steps; Home and End`,
            'aria-valuemin': least,
            'aria-valuemax': most,
            'aria-valuenow': least,
        }, (place) => move(...this.inside(place)));
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
        const sliders = live.div('live-controls');
        this.sliders = Object.entries(this.figure.sliders ?? {}).map(([name, { label, ...range }]) => {
            const control = live.control(label, range, (value) => this.set({ [name]: value }));
            sliders.append(control.element);
            const show = () => control.show(this.state[name], live.show(this.state[name]));
            show();
            return show;
        });
        return sliders;
    }

    makeValues() {
        const table = live.div('live-values');
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
        this.drawing.show(pen);
        for (const { circle, at } of this.handles) {
            const place = at(this.state);
            this.drawing.place(circle, place);
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
