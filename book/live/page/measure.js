// Error against run time, here: the samples of a scene, measured on this very machine.
live.Measure = class {
    static samplings = [[1, 'a regular grid', 'a'], [2, 'random', 'b'], [3, 'a stratified grid', 'c']];
    static size = [120, 90];
    // Logarithms of milliseconds and of errors.
    static area = { x: [-0.7, 4], y: [-3.4, -0.4] };

    constructor(before) {
        const scenes = Object.keys(live.locks).filter((name) => /^a0[4-7]/.test(name));
        this.scene = live.element('select', { 'aria-label': 'scene' }, ...scenes.map((name) => live.element('option', {}, name)));
        this.scene.value = 'a05-lighting-phong';
        this.status = live.element('output');
        const measure = live.button('measure', async () => {
            measure.disabled = true;
            await this.run([1, 4, 16, 64, 256], 1024).catch(live.complain(this.status));
            measure.disabled = false;
        });
        this.svg = live.svg('svg', { viewBox: `0 0 ${live.Pen.width} ${new live.Pen(live.Measure.area).height}` });
        const hint = 'Rendered by the lesson at 120 × 90, against 1024 stratified samples per pixel. Both are rounded to bytes, so that no error falls much below 1/510, the level line.';
        before.before(live.panel('Error against run time, on this machine', hint,
            live.element('div', { className: 'live-controls' }, this.scene, ' ', measure, ' ', this.status),
            live.element('div', { className: 'live-drawings' }, this.svg)));
        this.draw([]);
    }

    // One picture: its bytes and the milliseconds that it took.
    async render(samples, sampling, seed) {
        const start = performance.now();
        const { pixels } = await live.ask(`render ${this.scene.value}`, [...live.Measure.size, samples, sampling, seed, 6, 0, 0, 0, 1]);
        return [pixels, performance.now() - start];
    }

    // Measures each sampling at these numbers of samples; draws after each.
    async run(counts, reference) {
        this.curves = live.Measure.samplings.map(([sampling, name, kind]) => ({ sampling, name, kind, points: [] }));
        this.status.value = 'rendering the reference …';
        const [exact] = await this.render(reference, 3, 1);
        // The samplings take turns, so that other work of the machine disturbs them alike.
        for (const count of counts) {
            for (const { sampling, name, points } of this.curves) {
                this.status.value = `${name}, ${count} samples per pixel …`;
                const [pixels, time] = await this.render(count, sampling, 0);
                points.push([time, live.Measure.error(pixels, exact)]);
                this.draw(this.curves);
            }
        }
        this.status.value = 'measured';
    }

    // Root mean square over red, green and blue, for channels from 0 to 1.
    static error(pixels, exact) {
        let squares = 0;
        pixels.forEach((byte, i) => (squares += (byte - exact[i]) ** 2));
        // Opacity, each fourth byte, is the same in both.
        return Math.sqrt(squares / (pixels.length * 0.75)) / 255;
    }

    draw(curves) {
        const { x, y } = live.Measure.area;
        const pen = new live.Pen(live.Measure.area);
        for (let power = 0; power <= 3; power += 1) {
            pen.line([power, y[0]], [power, y[1]], 'thin');
            pen.text([power, y[0]], `${10 ** power} ms`);
        }
        for (let power = -3; power <= -1; power += 1) {
            pen.line([x[0], power], [x[1], power], 'thin');
            pen.text([x[0], power], `${10 ** power}`);
        }
        pen.line([x[0], Math.log10(1 / 510)], [x[1], Math.log10(1 / 510)], 'ink');
        curves.forEach(({ name, kind, points }, index) => {
            const logs = points.map(([time, error]) => [Math.log10(Math.max(time, 0.4)), Math.log10(Math.max(error, 5e-4))]);
            logs.forEach((place) => pen.dot(place, kind));
            if (logs.length > 1) {
                pen.path(logs, kind);
            }
            pen.text([2.4, -0.75 - 0.2 * index], name, kind);
        });
        this.svg.innerHTML = pen.shapes.join('');
    }
};

live.measure = live.tool('the-slope', (heading) => new live.Measure(heading));
