// Live pictures: a click on a rendered picture of the book renders it here and says
// whether it has the bytes of the tested one; then it can be turned and changed.

live.Picture = class {
    // Names as the module counts them.
    static places = ['one in the middle', 'a regular grid', 'random', 'a stratified grid'];
    static unturned = { yaw: 0, pitch: 0, zoom: 1 };

    constructor(image, name, lock) {
        Object.assign(this, { image, name, lock });
        this.frame = live.element('span', { className: 'live-picture', tabIndex: 0 });
        this.frame.setAttribute('role', 'button');
        this.frame.setAttribute('aria-label', `Render here: ${image.alt}`);
        // mdBook puts an image into a label that enlarges it.
        (image.closest('label') ?? image).replaceWith(this.frame);
        this.frame.append(image);
        this.frame.onclick = () => this.begin();
        live.keys(this.frame, { Enter: () => this.begin(), ' ': () => this.begin() });
    }

    async begin() {
        if (this.begun) {
            return;
        }
        this.begun = true;
        this.status = live.element('output', { className: 'live-status' }, 'Rendering …');
        this.frame.after(this.status);
        try {
            this.about = await live.ask(`about ${this.name}`);
        } catch (error) {
            this.status.value = `This picture cannot be rendered here: ${error.message}.`;
            return;
        }
        this.canvas = live.element('canvas', { className: 'live-canvas' });
        this.canvas.style.width = `${this.about.size[0]}px`;
        this.yours = live.Yours.of(this);
        this.update = live.newest((moving) => this.render(moving));
        this.look = live.newest((column, row) => this.probe(column, row));
        this.reset();
        await this.update(false);
        this.frame.append(this.canvas);
        this.frame.classList.add('live-begun');
        this.frame.setAttribute('role', 'application');
        this.frame.setAttribute('aria-label', `${this.image.alt}. Arrow keys turn, + and - zoom, 0 resets.`);
        this.addControls();
        this.listen();
    }

    reset() {
        const { size, samples, sampling, seed, depth } = this.about;
        this.shrunk = 2;
        this.settings = {
            width: size[0],
            height: size[1],
            samples: samples[0],
            sampling: sampling[0],
            seed: seed[0],
            depth: depth[0],
            engine: 0,
            ...live.Picture.unturned,
        };
        this.defaults = { ...this.settings };
    }

    // The settings in the order of the module; while the reader drags, with few samples,
    // and half as wide and high, or a quarter where that takes too long.
    numbers(moving) {
        const { width, height, samples } = this.settings;
        const small = {
            width: Math.ceil(width / this.shrunk),
            height: Math.ceil(height / this.shrunk),
            samples: Math.min(samples, 4),
        };
        return Object.values(moving ? { ...this.settings, ...small } : this.settings);
    }

    async render(moving) {
        const start = performance.now();
        let answer;
        try {
            answer = await live.ask(`render ${this.name}`, this.numbers(moving));
        } catch (error) {
            this.status.value = error.message;
            return;
        }
        this.milliseconds = performance.now() - start;
        // Twenty pictures a second look like a movement.
        if (moving && this.milliseconds > 50) {
            this.shrunk = 4;
        }
        live.paint(this.canvas, answer);
        this.say(answer.text, answer.size.join(' × '));
        if (!moving) {
            this.yours.forEach((yours) => yours.update(answer));
        }
    }

    say(hash, size) {
        const isDefault = Object.keys(this.defaults).every(
            (key) => this.settings[key] === this.defaults[key],
        );
        const equal = hash === this.lock;
        this.frame.dataset.state = !isDefault ? 'changed' : equal ? 'tested' : 'different';
        const verdict = {
            tested: `The same bytes as the tested picture: hash ${hash}.`,
            different: `NOT the bytes of the tested picture: hash ${hash}, locked ${this.lock}.`,
            changed: `Hash ${hash}.`,
        }[this.frame.dataset.state];
        const time = this.milliseconds.toFixed(this.milliseconds < 10 ? 1 : 0);
        this.status.value = `Rendered here in ${time} ms, ${size}. ${verdict}`;
    }

    // The new settings, rendered small at once and in full when the reader pauses.
    change(settings) {
        Object.assign(this.settings, settings);
        this.showSettings();
        clearTimeout(this.pause);
        this.pause = setTimeout(() => this.update(false), 200);
        return this.update(true);
    }

    turn(right, up) {
        if (this.about.turns[0]) {
            const { yaw, pitch } = this.settings;
            this.change({ yaw: yaw - right, pitch: Math.max(-3, Math.min(3, pitch - up)) });
        }
    }

    zoom(factor) {
        if (this.about.turns[0]) {
            const zoom = Math.max(0.05, Math.min(20, this.settings.zoom * factor));
            this.change({ zoom });
        }
    }

    startAgain() {
        this.reset();
        this.showSettings();
        clearTimeout(this.pause);
        return this.update(false);
    }

    listen() {
        const { canvas, frame } = this;
        // The width of the picture is half a turn.
        live.drag(canvas, (_, ...by) => this.turn(...by.map((way) => (way * Math.PI) / canvas.clientWidth)));
        canvas.onpointermove = (event) => {
            if (!event.buttons) {
                const { width, height } = this.settings;
                const column = Math.floor((event.offsetX / canvas.clientWidth) * width);
                const row = Math.floor((event.offsetY / canvas.clientHeight) * height);
                this.look(Math.min(Math.max(column, 0), width - 1), Math.min(Math.max(row, 0), height - 1));
            }
        };
        // Only after a click into the picture, so that the page still scrolls.
        frame.addEventListener('wheel', (event) => {
            if (document.activeElement === frame) {
                event.preventDefault();
                this.zoom(Math.exp(event.deltaY * 0.001));
            }
        });
        live.keys(frame, {
            ...live.arrows((right, up) => this.turn(right * 0.1, -up * 0.1)),
            '+': () => this.zoom(0.8),
            '-': () => this.zoom(1.25),
            0: () => this.startAgain(),
        });
    }

    async probe(column, row) {
        if (!this.about.turns[0]) {
            const [r, g, b] = this.canvas.getContext('2d').getImageData(column, row, 1, 1).data;
            this.probed.value = `Pixel ${column}, ${row}: the bytes ${r}, ${g}, ${b}`;
            return;
        }
        const { color, text, t, point, normal } = await live.ask(`probe ${this.name}`, [
            ...this.numbers(false),
            column,
            row,
        ]);
        const list = (numbers) => `(${numbers.map((x) => live.show(Number(x.toPrecision(3)))).join(', ')})`;
        const met = t ? `${text} at t = ${live.show(t[0])}, p = ${list(point)}, n = ${list(normal)}` : text;
        this.probed.value = `Pixel ${column}, ${row}: ${color ? `${list(color)}; ` : ''}${met}`;
    }

    addControls() {
        const { uses_sampling, uses_depth, turns } = this.about;
        const panel = live.element('span', { className: 'live-controls' });
        this.controls = [];
        const add = (label, input, show, read) => {
            panel.append(live.element('label', {}, `${label} `, input));
            this.controls.push(() => show(input));
            input.oninput = () => this.change(read(input));
        };
        const slider = (min, max) => live.element('input', { type: 'range', min, max, step: 1 });
        const choice = (names) =>
            live.element('select', {}, ...names.map((name, value) => live.element('option', { value }, name)));
        if (uses_sampling[0]) {
            const samples = live.element('output');
            add(
                'samples',
                slider(1, 12),
                (input) => {
                    input.value = Math.round(Math.sqrt(this.settings.samples));
                    samples.value = this.settings.samples;
                },
                // A grid has as many columns as rows, and a middle has one place.
                (input) => ({
                    samples: input.value ** 2,
                    sampling: input.value > 1 ? this.settings.sampling || 1 : this.settings.sampling,
                }),
            );
            panel.lastChild.append(samples);
            add(
                'their places',
                choice(live.Picture.places),
                (input) => (input.value = this.settings.sampling),
                (input) => ({ sampling: Number(input.value) }),
            );
        }
        if (uses_depth[0]) {
            const depth = live.element('output');
            add(
                'surfaces a ray may hit',
                slider(1, 12),
                (input) => (input.value = depth.value = this.settings.depth),
                (input) => ({ depth: Number(input.value) }),
            );
            panel.lastChild.append(depth);
        }
        if (turns[0]) {
            const zoom = (input) => (input.value = Math.round(-8 * Math.log2(this.settings.zoom)));
            add('closer', slider(-24, 24), zoom, (input) => ({ zoom: 2 ** (-input.value / 8) }));
            const sizes = ['quarter size', 'half size', 'full size', 'double size'];
            const [width, height] = this.about.size;
            add(
                '',
                choice(sizes),
                (input) => (input.value = Math.log2(this.settings.width / width) + 2),
                (input) => ({
                    width: width * 2 ** (input.value - 2),
                    height: Math.round(height * 2 ** (input.value - 2)),
                }),
            );
        }
        panel.append(live.element('button', { type: 'button', onclick: () => this.startAgain() }, 'reset'));
        this.probed = live.element('output', { className: 'live-probe' });
        this.probed.value = turns[0]
            ? 'Drag to turn, wheel to zoom; arrow keys, + and - do the same. Point at a pixel to see the surface that its ray met.'
            : 'Point at a pixel to see its bytes.';
        this.status.after(panel, this.probed);
        this.showSettings();
    }

    showSettings() {
        this.controls?.forEach((show) => show());
    }
};

// Makes every picture that the tests lock a live one, by the name of its file.
live.pictures = [];
if (live.works) {
    for (const image of document.querySelectorAll('main img:not(.img-wrapper > img)')) {
        const [, name] = /([^/]+)\.png$/.exec(image.getAttribute('src')) ?? [];
        if (live.locks[name]) {
            live.pictures.push(new live.Picture(image, name, live.locks[name]));
        }
    }
}
