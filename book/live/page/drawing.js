// Drawings: a pen that collects shapes, and the place on the page where they are shown with handles over them.

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

    // Lines across the drawing at places of an axis, 0 for x and 1 for y, each with its words.
    grid(axis, places) {
        for (const [place, words] of places) {
            const [from, to] = [0, 1].map((end) => (axis ? [this.area.x[end], place] : [place, this.area.y[end]]));
            this.line(from, to, 'grid');
            this.text(from, words, 'axis');
        }
    }
};

live.Drawing = class {
    constructor(area, label) {
        this.drawn = live.svg('g', {});
        this.svg = live.svg('svg', { role: 'group', 'aria-label': label }, this.drawn);
        this.show(new live.Pen(area));
    }

    show(pen) {
        this.pen = pen;
        this.svg.setAttribute('viewBox', `0 0 ${live.Pen.width} ${pen.height}`);
        this.drawn.innerHTML = pen.shapes.join('');
    }

    // A handle: `move` gets the place to which it is dragged.
    handle(attributes, move) {
        const circle = live.svg('circle', { r: 12, class: 'live-handle', ...attributes });
        live.drag(circle, (event) => {
            const box = this.svg.getBoundingClientRect();
            const shrunk = live.Pen.width / box.width;
            move(this.pen.from([(event.clientX - box.left) * shrunk, (event.clientY - box.top) * shrunk]));
        });
        this.svg.append(circle);
        return circle;
    }

    // Moves a handle to a place.
    place(circle, at) {
        circle.setAttribute('transform', `translate(${this.pen.to(at)})`);
    }
};
