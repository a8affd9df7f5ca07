// Switch it off: each omission of the lesson is a switch. Work is counted at once, the bytes are compared, and times
// are measured in turns.
live.LeftOut = class {
    static scenes = ['a05-lighting-phong', 'a06-shadows-reflection-sphere', 'a06-shadows-reflection-aab', 'a07-transforms-box-transformations'];
    static rounds = 15;

    constructor(heading) {
        this.scene = live.element('select', { 'aria-label': 'scene', onchange: () => this.open() },
            ...live.LeftOut.scenes.map((name) => live.element('option', {}, name)));
        // The editor's scene, in the link that leads here.
        const [, written] = /^#scene=(.*)/.exec(location.hash) ?? [];
        if (written) {
            this.scene.append(live.element('option', { value: `file\n${decodeURIComponent(written)}`, selected: true }, 'the scene of the editor'));
        }
        this.engine = live.element('input', { type: 'checkbox', onchange: () => this.open() });
        this.question = live.element('div', { className: 'live-question' });
        this.switches = live.element('ul', { className: 'live-switches' });
        this.canvas = live.element('canvas', { role: 'img' });
        this.bytes = live.element('output');
        this.counts = live.element('table', { className: 'live-counts' });
        this.time = live.element('output', { className: 'live-said' });
        this.measure = live.button('time it, in turns', () => this.run());
        this.end = live.button('stop', () => this.clock.stop('stopped'));
        this.end.disabled = true;
        this.bar = live.element('progress', { max: live.LeftOut.rounds, value: 0, 'aria-label': 'rounds' });
        const hint = 'For a scene of your own, follow the link “what does it leave out?” of the editor. Counted in a picture of at most 96 pixels in width, with the scene’s samples and depth, as the command “render --explain” counts. A switch that is off does its work, and all switches that are off do theirs together. The engine adds its tree and its packets of rays.';
        this.root = live.panel('Switch it off', hint,
            live.element('div', { className: 'live-controls' }, this.scene, ' ', live.element('label', {}, this.engine, ' by the engine')),
            this.question,
            live.element('div', { className: 'live-drawings' }, live.element('div', { className: 'live-beside' }, this.canvas, this.bytes), this.counts),
            this.switches,
            live.element('div', { className: 'live-controls' }, this.measure, ' ', this.end, ' ', this.bar), this.time);
        this.complain = ({ message }) => (this.root.dataset.error = message);
        // A module of its own, which is stopped without the other figures.
        this.clock = new live.Module();
        this.update = live.newest(() => this.count(), this.complain);
        this.guessed = new Set();
        heading.nextElementSibling.after(this.root);
        const seen = new IntersectionObserver(([{ isIntersecting }]) => {
            if (isIntersecting) {
                seen.disconnect();
                this.ready = this.open();
            }
        }, { rootMargin: '200px' });
        seen.observe(this.root);
    }

    // The settings of a request: the renderer, and the bits of the work that is put back.
    numbers(...more) {
        return [Number(this.engine.checked), ...more];
    }

    // Another scene or another renderer: all switches are on.
    async open() {
        delete this.root.dataset.error;
        this.time.value = '';
        this.bar.value = 0;
        try {
            this.work = await live.ask(`work ${this.scene.value}`, this.numbers());
        } catch (error) {
            return this.complain(error);
        }
        const [kinds, ...lines] = this.work.text.split('\n');
        this.kinds = kinds.split('\t');
        this.omissions = lines.map((line, index) => {
            const [words, because] = line.split('\t');
            const alone = [...this.work.alone.slice(index * this.kinds.length, (index + 1) * this.kinds.length)];
            const box = live.element('input', { type: 'checkbox', checked: true, onchange: () => this.update() });
            return { words, because, alone, box, bit: this.work.bits[index] };
        });
        this.ask();
        this.list();
        return this.update();
    }

    get key() {
        return `${this.engine.checked} ${this.scene.value}`;
    }

    // What an omission saves alone: rays, tests and powers.
    static total({ alone }) {
        return alone.reduce((sum, count) => sum + count, 0);
    }

    inWords(counts) {
        const words = this.kinds.flatMap((kind, index) => (counts[index] ? [`${counts[index].toLocaleString('en')} ${kind}`] : []));
        return words.join(', ') || 'nothing';
    }

    // A prediction first; then the switches say what they save.
    ask() {
        const verdict = live.element('output');
        const most = this.omissions.reduce((best, next) => (live.LeftOut.total(next) > live.LeftOut.total(best) ? next : best));
        const right = live.LeftOut.total(most) ? most.words : 'none of them';
        const because = live.LeftOut.total(most) ? `It saves ${this.inWords(most.alone)}` : 'This scene needs all of the work';
        const choice = live.element('select', { 'aria-label': 'your guess' }, ...[...this.omissions.map(({ words }) => words), 'none of them'].map((words) => live.element('option', {}, words)));
        const answer = (guess) => {
            this.guessed.add(this.key);
            const yes = guess === undefined ? '' : guess === right ? 'Yes. ' : `No: ${right}. `;
            verdict.value = `${yes}${because}.`;
            button.disabled = true;
            this.list();
            this.update();
        };
        const button = live.button('that one', () => answer(choice.value));
        this.question.replaceChildren('Which switch saves most rays, tests and powers in this scene? ', choice, ' ', button, verdict);
        if (this.guessed.has(this.key)) {
            answer();
        }
    }

    list() {
        const isKnown = this.guessed.has(this.key);
        this.switches.replaceChildren(...this.omissions.map((omission) => {
            const saved = isKnown ? ` Saves ${this.inWords(omission.alone)}.` : '';
            return live.element('li', {}, live.element('label', {}, omission.box, ` Leave out ${omission.words}: ${omission.because}.${saved}`));
        }));
    }

    // The bits of the switches that are off.
    get putBack() {
        return this.omissions.filter(({ box }) => !box.checked).reduce((bits, { bit }) => bits + 2 ** bit, 0);
    }

    async count() {
        const { counts, pixels, size } = await live.ask(`done ${this.scene.value}`, this.numbers(this.putBack));
        live.paint(this.canvas, { size, pixels });
        this.canvas.setAttribute('aria-label', `The picture of ${this.scene.selectedOptions[0].textContent}`);
        const wrong = pixels.filter((byte, index) => byte !== this.work.pixels[index]).length;
        this.bytes.value = wrong ? `${wrong} bytes are NOT those of the lesson.` : `All ${pixels.length / 4 * 3} bytes are the same as with all switches on.`;
        const { done, all } = this.work;
        const row = (name, cells, tag = 'td') => live.element('tr', {}, live.element('th', { scope: 'row' }, name), ...cells.map((cell) => live.element(tag, {}, cell)));
        const isKnown = this.guessed.has(this.key) || this.putBack > 0;
        this.counts.replaceChildren(
            row('', ['all on', 'yours', 'all work'], 'th'),
            ...this.kinds.flatMap((kind, index) => {
                if (!all[index] && !done[index]) {
                    return [];
                }
                const meter = live.element('meter', { max: Math.max(all[index], counts[index]), value: counts[index], 'aria-label': kind });
                const known = isKnown ? all[index].toLocaleString('en') : '?';
                return [row(kind, [done[index].toLocaleString('en'), live.element('span', {}, counts[index].toLocaleString('en'), ' ', meter), known])];
            }));
        this.latest = [...counts];
        this.root.dataset.drawn = '';
    }

    // One picture, rendered so often that a browser's clock can time it.
    async timed(engine, putBack, rounds) {
        const start = performance.now();
        await this.clock.ask(`timed ${this.scene.value}`, [engine, putBack, rounds]);
        return performance.now() - start;
    }

    // Rounds in which the three take turns, so that other work of the machine disturbs them alike.
    async run() {
        this.measure.disabled = true;
        this.end.disabled = false;
        try {
            this.time.value = await this.compare();
        } catch ({ message }) {
            this.time.value = message;
        }
        this.measure.disabled = false;
        this.end.disabled = true;
    }

    async compare() {
        const engine = Number(this.engine.checked);
        // Beside the engine stands the lesson as it is, and beside switches the same code with all of them on.
        const methods = [[0, engine ? -1 : 0], [engine, this.putBack], [0, 2 ** 16 - 1]];
        this.bar.value = 0;
        this.time.value = 'How many pictures does the clock of this browser need? …';
        let [many, least] = [1, 0];
        while ((least = Math.min(await this.timed(...methods[0], many), await this.timed(...methods[1], many))) < 30 && many < 1024) {
            many *= 2;
        }
        const times = methods.map(() => []);
        for (let round = 1; round <= live.LeftOut.rounds; round += 1) {
            // There and back, so that none always follows the same other one.
            const order = round % 2 ? [0, 1, 2] : [2, 1, 0];
            for (const index of order) {
                times[index].push(await this.timed(...methods[index], many));
            }
            this.bar.value = round;
            this.time.value = `Round ${round} of ${live.LeftOut.rounds}, ${many} pictures each …`;
        }
        const [base, yours, everything] = times;
        const quotient = async (dividends) => (await live.ask('quotient', [...dividends, ...base])).text;
        const beside = engine ? 'by the lesson' : 'with all switches on';
        const words = (text) => (/^no /.test(text) ? `makes ${text}` : `takes ${text} times as long`);
        const coarse = least < 10 ? ' The clock of this browser is too coarse for it.' : '';
        const each = [...base].sort((a, b) => a - b)[base.length >> 1] / many;
        return `Beside the picture ${beside} (${live.show(Number(each.toPrecision(2)))} ms): yours ${words(await quotient(yours))}; all work ${words(await quotient(everything))}. Medians of ${live.LeftOut.rounds} rounds, with the interval that holds the true one with 95 %.${coarse}`;
    }
};

live.leftOut = live.tool('switch-it-off', (heading) => new live.LeftOut(heading));
