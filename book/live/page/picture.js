// Live pictures: a click on a rendered picture of the book renders it here and says
// whether it has the bytes of the tested one; then it can be turned and changed.

live.Picture = class {
    // Names as the module counts them.
    static places = ['one in the middle', 'a regular grid', 'random', 'a stratified grid'];

    constructor(image, name, lock) {
        Object.assign(this, { image, name, lock });
        this.frame = live.element('span', { className: 'live-picture', tabIndex: 0, role: 'button', 'aria-label': `Render here: ${image.alt}` });
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
        this.status ??= live.element('output', { className: 'live-status' });
        this.status.value = 'Rendering …';
        this.frame.after(this.status);
        try {
            this.about = await live.ask(`about ${this.name}`);
        } catch (error) {
            this.status.value = `This picture cannot be rendered here: ${error.message}.`;
            this.begun = false;
            return;
        }
        this.canvas = live.element('canvas', { className: 'live-canvas' });
        this.canvas.style.width = `${this.about.settings[0]}px`;
        this.yours = live.Yours.of(this);
        this.probed = live.element('output', { className: 'live-probe' });
        this.update = live.newest((moving) => this.render(moving), live.complain(this.status));
        this.look = live.newest((column, row) => this.probe(column, row), live.complain(this.probed));
        this.reset();
        await this.update(!this.lock);
        this.frame.append(this.canvas);
        this.frame.classList.add('live-begun');
        this.frame.setAttribute('role', 'application');
        this.frame.setAttribute('aria-label', `${this.image.alt}. Arrow keys turn, + and - zoom, 0 resets.`);
        this.addControls();
        this.listen();
    }

    reset() {
        this.shrunk = 2;
        const [width, height, samples, sampling, seed, depth, engine] = this.about.settings;
        this.settings = { width, height, samples, sampling, seed, depth, engine, yaw: 0, pitch: 0, zoom: 1 };
        this.defaults = { ...this.settings };
    }

    // The settings in the order of the module, some of them changed.
    numbers(changes) {
        return Object.values({ ...this.settings, ...changes });
    }

    // While the reader drags: few samples, and half as wide and high, or a quarter where that
    // takes too long.
    small() {
        const { width, height, samples } = this.settings;
        const [w, h] = [width, height].map((side) => Math.ceil(side / this.shrunk));
        return { width: w, height: h, samples: Math.min(samples, 4) };
    }

    async render(moving) {
        const start = performance.now();
        const answer = await live.ask(`render ${this.name}`, this.numbers(moving && this.small()));
        this.milliseconds = performance.now() - start;
        // Twenty pictures a second look like a movement.
        if (moving && this.milliseconds > 50) {
            this.shrunk = 4;
        }
        live.paint(this.canvas, answer);
        this.say(answer.text, answer.size.join(' × '));
        if (!moving) {
            this.yours.forEach((yours) => yours.update(answer));
            this.explained?.update();
        }
    }

    say(hash, size) {
        const isChanged = Object.entries(this.defaults).some(([key, value]) => this.settings[key] !== value);
        this.frame.dataset.state = isChanged || !this.lock ? 'changed' : hash === this.lock ? 'tested' : 'different';
        const verdict = {
            tested: 'The same bytes as the tested picture.',
            different: `NOT the bytes of the tested picture: hash ${hash}, locked ${this.lock}.`,
            changed: '',
        }[this.frame.dataset.state];
        const time = this.milliseconds.toFixed(this.milliseconds < 10 ? 1 : 0);
        this.hash = hash;
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
        const { yaw, pitch } = this.settings;
        this.change({ yaw: yaw - right, pitch: Math.max(-3, Math.min(3, pitch - up)) });
    }

    zoom(factor) {
        this.change({ zoom: Math.max(0.05, Math.min(20, this.settings.zoom * factor)) });
    }

    startAgain() {
        this.reset();
        this.showSettings();
        clearTimeout(this.pause);
        return this.update(false);
    }

    listen() {
        const { canvas, frame } = this;
        const pixel = ({ offsetX, offsetY }) => {
            const { width, height } = this.settings;
            const [column, row] = [(offsetX / canvas.clientWidth) * width, (offsetY / canvas.clientHeight) * height];
            return [Math.min(Math.max(Math.floor(column), 0), width - 1), Math.min(Math.max(Math.floor(row), 0), height - 1)];
        };
        canvas.onpointermove = (event) => {
            if (!event.buttons) {
                this.look(...pixel(event));
            }
        };
        if (!this.about.turns[0]) {
            return;
        }
        // The width of the picture is half a turn.
        const turn = (_, ...by) => this.turn(...by.map((way) => (way * Math.PI) / canvas.clientWidth));
        live.drag(canvas, turn, (event) => this.tapped(...pixel(event)));
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
        const { color, steps } = await this.trace({ samples: 1, sampling: 0 }, [column, row]);
        const list = (numbers) => `(${numbers.map((x) => live.show(Number(x.toPrecision(3)))).join(', ')})`;
        const step = (kind) => steps.find((step) => step.kind === kind);
        const { t, p, n } = step('hit')?.values ?? {};
        const met = t ? `${step('test').name}, at t = ${live.show(t[0])}, p = ${list(p)}, n = ${list(n)}` : 'the background';
        this.probed.value = `Pixel ${column}, ${row}: ${list(color)}; ${met}`;
    }

    // The numbers behind a pixel, with some settings changed.
    async trace(changes, pixel) {
        const { text } = await live.ask(`trace ${this.name}`, [...this.numbers(changes), ...pixel]);
        return JSON.parse(text);
    }

    // Opens the page where the scene is a text.
    async edit() {
        const { text } = await live.ask(`export ${this.name}`);
        location.href = `scene-editor.html#scene=${encodeURIComponent(text)}`;
    }

    // A click on a pixel.
    tapped(...pixel) {
        return this.explain(...pixel);
    }

    explain(...pixel) {
        this.explained ??= new live.Trace(this);
        return this.explained.open(pixel);
    }

    addControls() {
        const { uses_sampling, uses_depth, turns } = this.about;
        const panel = live.element('span', { className: 'live-controls' });
        this.controls = [];
        const add = (label, range, show, read) => {
            const control = live.control(label, range, (value) => this.change(read(value)));
            panel.append(control.element);
            this.controls.push(() => control.show(...show(this.settings)));
        };
        if (uses_sampling[0]) {
            // A grid has as many columns as rows, and a middle has one place.
            add('samples', { min: 1, max: 12 }, ({ samples }) => [Math.sqrt(samples), samples], (side) => ({
                samples: side ** 2,
                sampling: side > 1 ? this.settings.sampling || 1 : this.settings.sampling,
            }));
            add('their places', { choices: live.Picture.places }, ({ sampling }) => [sampling], (sampling) => ({ sampling }));
        }
        if (uses_depth[0]) {
            add('surfaces a ray may hit', { min: 1, max: 12 }, ({ depth }) => [depth], (depth) => ({ depth }));
        }
        const button = (...how) => panel.append(live.button(...how), ' ');
        if (turns[0]) {
            add('closer', { min: -24, max: 24 }, ({ zoom }) => [Math.round(-8 * Math.log2(zoom)), ''], (step) => ({ zoom: 2 ** (-step / 8) }));
            const sizes = ['quarter size', 'half size', 'full size', 'double size'];
            add('drawn at', { choices: sizes }, ({ width }) => [Math.round(Math.log2(width / this.defaults.width)) + 2], (size) => {
                const [width, height] = this.about.settings.map((side) => Math.max(1, Math.round(side * 2 ** (size - 2))));
                return { width, height };
            });
            button('explain a pixel', () => this.explain(this.settings.width >> 1, this.settings.height >> 1));
        }
        if (turns[0] && this.lock) {
            button('edit the scene', () => this.edit().catch(live.complain(this.probed)));
        }
        button('reset', () => this.startAgain());
        this.probed.value = turns[0]
            ? 'Drag to turn, wheel to zoom; arrow keys, + and - do the same. Point at a pixel to see the surface that its ray met; click on it to explain it.'
            : 'Point at a pixel to see its bytes.';
        this.status.after(panel, this.probed);
        this.showSettings();
    }

    showSettings() {
        this.controls?.forEach((show) => show());
    }
};

// Makes every picture that the tests lock a live one, by the name of its file.
live.pictures = live.images('img').flatMap((image) => {
    const [, name] = /([^/]+)\.png$/.exec(image.getAttribute('src')) ?? [];
    return live.locks[name] ? [new live.Picture(image, name, live.locks[name])] : [];
});
