// Switch it off: each omission of the lesson is a switch. Work is counted at once, the bytes are compared, and times
// are measured in turns.
live.LeftOut = class {
    // Their names in the module, and for the reader.
    static scenes = [
        ['a06-shadows-reflection-sphere', 'sphere, of stage 6'],
        ['a05-lighting-phong', 'phong, of stage 5'],
        ['a07-transforms-box-transformations', 'box-transformations, of stage 7'],
        ['a07-transforms-disc', 'disc, of stage 7'],
    ];

    constructor(heading) {
        // The editor's scene, in the link that leads here.
        const linked = live.linkedScene();
        const own = linked ? [[linked, 'the scene of the editor']] : [];
        const { textContent } = document.querySelector('main code.language-toml');
        this.scene = live.select('scene', [...own, ...live.LeftOut.scenes, [`file\n${textContent}`, 'a hundred balls, as below']], () => this.open());
        this.engine = live.element('input', { type: 'checkbox', onchange: () => this.open() });
        this.question = live.div('live-asked');
        this.switches = live.element('ol', { className: 'live-switches' });
        this.canvas = live.element('canvas', { role: 'img', width: 96, height: 72 });
        this.poster = live.poster(`pictures/${live.LeftOut.scenes[0][0]}.png`);
        this.bytes = live.element('output');
        this.counts = live.element('table', { className: 'live-counts' });
        this.run = new live.Run('time it, in turns', () => this.compare());
        const hint = 'For a scene of your own, follow the link “what does it leave out?” of the editor. Counted in a picture of at most 96 pixels in width, with the scene’s samples and depth, as the command “render --explain” counts: the switches go off one after the other, from the first, so that what they save adds up to all work. Where two of them leave out the same ray, the later one has it. Times are medians, with the interval that holds the true one with 95 % in this run.';
        this.root = live.panel('Switch it off', live.fold('How it is counted', hint),
            live.div('live-controls', this.scene, ' ', live.element('label', {}, this.engine, ' by the engine')),
            this.question,
            live.div('live-drawings', live.div('live-beside', live.div('', this.canvas, this.poster), this.bytes), this.counts),
            'Leave out', this.switches,
            live.div('live-controls', ...this.run.controls));
        this.complain = live.failure(this);
        this.update = live.newest(() => this.count(), this.complain);
        // The questions of scenes and renderers, and those that are answered.
        this.questions = {};
        this.answered = new Set();
        heading.nextElementSibling.after(this.root);
        live.seen(this.root, () => (this.ready ??= this.open()));
    }

    // Another scene or another renderer: all switches are on. Until its work is counted, nothing is shown of the one before.
    async open() {
        const { key } = this;
        delete this.root.dataset.error;
        await this.run.forget();
        this.run.status.value = '';
        for (const part of [this.question, this.switches, this.counts]) {
            part.replaceChildren();
        }
        this.bytes.value = 'counting …';
        let work;
        try {
            work = await live.ask(`work ${this.scene.value}`, this.numbers());
        } catch (error) {
            this.bytes.value = '';
            return this.complain(error);
        }
        if (key !== this.key) {
            return undefined;
        }
        this.work = work;
        const { text, bits, saved } = this.work;
        const [kinds, ...lines] = text.split('\n');
        this.kinds = kinds.split('\t');
        const { length } = this.kinds;
        this.omissions = lines.map((words, index) => ({
            words,
            bit: bits[index],
            saved: saved.slice(index * length, (index + 1) * length),
            box: live.element('input', { type: 'checkbox', checked: true, onchange: () => this.run.forget().then(this.update) }),
            saves: live.element('span'),
        }));
        this.switches.replaceChildren(...this.omissions.map(({ words, box, saves }) =>
            live.element('li', {}, live.element('label', {}, box, ` ${words}`, saves))));
        this.question.replaceChildren(this.questions[this.key] ??= this.ask());
        return this.update();
    }

    // The settings of a request: the renderer, and the bits of the work that is put back.
    numbers(...more) {
        return [Number(this.engine.checked), ...more];
    }

    get key() {
        return `${this.engine.checked} ${this.scene.value}`;
    }

    inWords(counts) {
        const words = this.kinds.flatMap((kind, index) => (counts[index] ? [`${counts[index].toLocaleString('en')} ${kind}`] : []));
        return words.join(', ') || 'nothing';
    }

    // A prediction first; then the switches say what each saves.
    ask() {
        const { key, omissions } = this;
        const sums = omissions.map(({ saved }) => saved.reduce((sum, count) => sum + count, 0));
        const most = Math.max(...sums);
        const choices = [...omissions.map((_, index) => index + 1), 'none'];
        const right = most ? choices.filter((_, index) => sums[index] === most) : ['none'];
        const because = most ? right.map((choice) => `${choice} saves ${this.inWords(omissions[choice - 1].saved)}`).join(', and ') : 'this scene needs all of the work';
        return live.question('Which switch saves most in this scene, if a ray, a test and a power count alike?', choices, (guess) => {
            this.answered.add(key);
            this.update();
            return `${right.includes(choices[guess]) ? 'Yes' : 'No'}: ${because}.`;
        });
    }

    // The bits of the switches that are off.
    get putBack() {
        return this.omissions.filter(({ box }) => !box.checked).reduce((bits, { bit }) => bits + 2 ** bit, 0);
    }

    async count() {
        const { counts, pixels, size } = await live.ask(`done ${this.scene.value}`, this.numbers(this.putBack));
        this.poster.remove();
        live.paint(this.canvas, { size, pixels });
        this.canvas.setAttribute('aria-label', `The picture of ${this.scene.selectedOptions[0].textContent}`);
        const wrong = pixels.filter((byte, index) => byte !== this.work.pixels[index]).length;
        this.bytes.value = wrong ? `${wrong} bytes are NOT those of the lesson.` : `All ${pixels.length / 4 * 3} bytes are the same as with all switches on.`;
        this.show(counts);
        this.root.dataset.drawn = '';
    }

    // The work that is counted; that of all work is known after the guess, or to who has tried.
    show(counts) {
        this.latest = counts;
        const { done, all } = this.work;
        const isAnswered = this.answered.has(this.key);
        const row = (name, cells, tag = 'td') => live.element('tr', {}, live.element('th', { scope: 'row' }, name), ...cells.map((cell) => live.element(tag, {}, cell)));
        const rows = this.kinds.map((kind, index) => {
            const [least, now, most] = [done, counts, all].map((list) => list[index]);
            const isKnown = isAnswered || this.putBack;
            const known = isKnown ? most.toLocaleString('en') : '?';
            // A part of all work would tell the answer.
            const meter = live.element('meter', { max: isKnown ? Math.max(most, now) : now, value: now, 'aria-label': kind });
            return most || least ? row(kind, [least.toLocaleString('en'), live.element('span', {}, now.toLocaleString('en'), ' ', meter), known]) : '';
        });
        this.counts.replaceChildren(row('', ['all on', 'yours', 'all work'], 'th'), ...rows);
        for (const { saved, saves } of this.omissions) {
            saves.textContent = isAnswered && saved.some(Boolean) ? `: saves ${this.inWords(saved)}` : '';
        }
    }

    // The three take turns, so that other work of the machine disturbs them alike.
    async compare() {
        let quotients;
        let base;
        const methods = `|left-out ${this.scene.value}`;
        const measured = await this.run.turns(methods, this.numbers(this.putBack), 30, ([{ seconds }], lines) => {
            base = seconds;
            quotients = lines.map(({ quotient }) => (/^no /.test(quotient) ? `makes ${quotient}` : `takes ${quotient} times as long`));
        });
        const beside = this.engine.checked ? 'by the lesson' : 'with all switches on';
        return `Beside the picture ${beside} (${live.time(base)}): yours ${quotients[1]}; all work ${quotients[2]}; ${[measured, ...this.run.doubts()].join('. ')}`;
    }
};

live.leftOut = live.tool('switch-it-off', (heading) => new live.LeftOut(heading));
