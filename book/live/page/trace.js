// Every number behind a pixel of a live picture, taken by the code of the lesson: the rays of a
// sample from the side and from above, and the steps of one ray, with their formulas.
live.Trace = class {
    // By the kind of the step, or by the type of the object or material. The symbols are those of
    // the chapters, and of the numbers beside them.
    static formulas = {
        sample: 'x = column + (place₁ − ½),  y = height − 1 − row − (place₂ − ½)',
        ray: 'r(t) = o + t d',
        Plane: 't = (a − o)·n / (d·n)',
        Sphere: '|o + t d − c| = r',
        AxisAlignedBox: 'tᵢ = (boundᵢ − oᵢ) / dᵢ: in after the last entry, out at the first exit',
        Triangle: 'o + t d = α a + β b + γ c',
        Disc: 't = (c − o)·n / (d·n),  |o + t d − c| ≤ r',
        'object ray': 'o′ = M⁻¹ o,  d′ = M⁻¹ d, with the same t',
        hit: 'p = o + t d',
        ambient: 'c = cd ca',
        light: 'n·l = cos of the angle in degrees',
        'shadow ray': 'a hit with 0 < t < end blocks the light',
        offset: 'p′ = p ± 64 ε m n',
        Lambert: 'c = cd cl (n·l)',
        Phong: 'c = cd cl (n·l) + cs cl (e·r)^exponent',
        'color of Lambert': 'c = ambient light + light of each lamp',
        'color of Phong': 'c = ambient light + light of each lamp',
        mirror: 'cr: the fraction that the reflected ray adds',
        'reflected ray': 'd′ = d − 2 (d·n) n',
        radiance: 'f = c₁ + cr₁ (c₂ + cr₂ (c₃ + …))',
        mean: 'c = (f₁ + … + f_N) / N,  byte = ⌊255 c + ½⌋',
    };

    constructor(picture) {
        Object.assign(this, { picture, at: 0, pixel: [0, 0], rays: [] });
        this.numbers = ['column', 'row'].map((name, i) => {
            const change = ({ target }) => this.open(Object.assign([...this.pixel], { [i]: Number(target.value) }));
            return live.element('input', { type: 'number', min: 0, 'aria-label': name, onchange: change });
        });
        this.where = live.element('output');
        this.status = live.element('output');
        const complain = live.complain(this.status);
        this.update = live.newest(() => this.answer(), complain);
        const go = (by) => this.show(this.at + by).catch(complain);
        this.list = live.element('ul', { className: 'live-steps' });
        this.drawings = live.element('div');
        this.shadow = this.drawings.attachShadow({ mode: 'open' });
        this.mark = live.element('span', { className: 'live-pixel' });
        const hint = 'The arrow keys ← and → go from ray to ray. The name of a step leads to its section. Dashed is light that does not arrive. The command explain prints the same numbers, with all digits.';
        this.root = live.panel('Explain a pixel', hint,
            live.div('live-controls', 'column ', this.numbers[0], ' row ', this.numbers[1], ' ', this.status),
            this.drawings,
            live.div('', live.button('←', () => go(-1)), ' ', live.button('→', () => go(1)), ' ', this.where, ' ', live.button('close', () => this.close())),
            this.list);
        this.root.tabIndex = 0;
        live.keys(this.root, { ArrowLeft: () => go(-1), ArrowRight: () => go(1), Escape: () => this.close() });
    }

    // Shows a pixel by its column and row.
    async open(pixel) {
        Object.assign(this, { pixel, at: 0 });
        if (!this.root.isConnected) {
            live.caption(this.picture.image).after(this.root);
            this.picture.frame.append(this.mark);
        }
        this.root.focus({ preventScroll: true });
        await this.update();
        this.root.scrollIntoView({ block: 'nearest', behavior: 'smooth' });
    }

    close() {
        this.root.remove();
        this.mark.remove();
        this.picture.frame.focus();
    }

    async answer() {
        if (!this.root.isConnected) {
            return;
        }
        const { picture, numbers, mark } = this;
        const size = [picture.settings.width, picture.settings.height];
        // A place beside the picture is moved into it.
        this.pixel = this.pixel.map((place, i) => Math.min(Math.max(Math.floor(place), 0), size[i] - 1));
        const percents = this.pixel.map((place, i) => {
            Object.assign(numbers[i], { value: place, max: size[i] - 1 });
            return `${((place + 0.5) / size[i]) * 100}%`;
        });
        Object.assign(mark.style, { left: percents[0], top: percents[1] });
        const { bytes, steps } = await picture.trace({}, this.pixel);
        this.rays = live.Trace.rays(steps);
        this.drawn = undefined;
        const shown = picture.canvas.getContext('2d').getImageData(...this.pixel, 1, 1).data;
        const verdict = bytes.every((byte, i) => byte === shown[i]) ? 'as in the picture' : 'NOT as in the picture';
        this.status.value = `bytes ${bytes.join(', ')}${picture.canvas.width === size[0] ? `, ${verdict}` : ''}`;
        await this.show(this.at);
    }

    // The steps of each ray: those of the camera begin with a sample, and last come the sums.
    static rays(steps) {
        const rays = [];
        for (const step of steps) {
            if (['sample', 'reflected ray', 'radiance'].includes(step.kind)) {
                rays.push([]);
            }
            rays.at(-1).push(step);
        }
        return rays;
    }

    async show(at) {
        this.at = Math.min(Math.max(at, 0), this.rays.length - 1);
        const steps = this.rays[this.at];
        if (!steps) {
            return;
        }
        this.where.value = `${this.at + 1} of ${this.rays.length}: ${steps[0].name}`;
        this.list.replaceChildren(...steps.map((step) => this.step(step)));
        const samples = this.rays.slice(0, this.at + 1).flatMap(([{ kind }], i) => (kind === 'sample' ? [i] : []));
        const sum = steps[0].kind === 'radiance';
        await this.draw(samples.length - 1, sum ? undefined : this.at - samples.at(-1) + 1);
    }

    // The drawing of a sample, in which one of its rays stands out.
    async draw(sample, ray) {
        this.standsOut = ray ? `.curve:not(.ray${ray}) { opacity: 0.25 } .ray${ray} { stroke-width: 3 }` : '';
        if (this.drawn !== sample) {
            this.drawn = sample;
            const { picture, pixel } = this;
            const { text, views } = await live.ask(`drawing ${picture.name}`, [...picture.numbers(), ...pixel, sample]);
            this.shadow.innerHTML = `${text}${text}<style>
                :host { display: flex; flex-wrap: wrap }
                svg { flex: 1 1 18em; min-width: 0; height: auto; font-size: 15px !important }
            </style><style></style>`;
            // Both views are in one drawing, beside each other.
            for (const [index, svg] of [...this.shadow.querySelectorAll('svg')].entries()) {
                const view = views.slice(4 * index, 4 * index + 4);
                Object.entries({ viewBox: view.join(' '), width: view[2], height: view[3] }).forEach((field) => svg.setAttribute(...field));
            }
        }
        // The first drawing may still be on its way.
        if (this.shadow.lastChild) {
            this.shadow.lastChild.textContent = this.standsOut;
        }
    }

    // A step: its name, which leads to its section, outcome, numbers and formula.
    step({ level, kind, name, about, outcome, values, section }) {
        const { formulas } = live.Trace;
        const formula = formulas[`${kind} of ${about}`] ?? formulas[kind] ?? formulas[about] ?? '';
        const numbers = Object.entries(values).map(([symbol, list]) => {
            const shown = list.map(live.show);
            return live.element('span', {}, `${symbol} = ${list.length === 1 ? shown : `(${shown.join(', ')})`}`);
        });
        const item = live.element('li', {}, live.element('a', { href: section.replace('.md', '.html') }, name), ` ${outcome} `, ...numbers, live.element('i', {}, formula));
        item.style.marginLeft = `${level}em`;
        return item;
    }
};
