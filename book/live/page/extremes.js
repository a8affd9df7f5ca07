// Where does it break? One number of a problem goes from harmless to extreme: the errors of the protocol's formula
// and of ours over the whole range, and under the knob all digits and a picture.
live.Extremes = class {
    // Where the powers of ten and the errors lie in the drawing: from below 1 ulp to no answer.
    static area = { x: [-1.8, 11.7], y: [-1, 7.7] };
    static errors = { ulp: [-1, 17], radii: [-17, 1] };
    static none = 6.8;

    // Takes the place of the picture that shows recorded errors.
    constructor(image) {
        this.problem = live.select('problem', [], () => this.choose().catch(this.complain));
        this.drawing = new live.Drawing(live.Extremes.area, 'errors');
        this.knob = live.element('input', { type: 'range', min: 0, oninput: () => this.turn(Number(this.knob.value)) });
        this.at = live.element('output');
        this.question = live.div('live-asked');
        this.digits = live.element('dl', { className: 'live-digits' });
        this.canvas = live.element('canvas', { width: 248, height: 120, role: 'img' });
        this.shown = live.element('figcaption');
        this.poster = live.poster(image.src);
        const beside = live.div('live-beside', this.canvas, live.div('live-both', live.element('span', {}, 'protocol’s'), live.element('span', {}, 'ours')), this.shown);
        const hint = 'The band is what the problem allows: how far its answer moves when the given numbers are rounded. Higher up, a formula loses digits that it could have kept. At “half” about eight of sixteen digits are wrong; at “none” there is no answer.';
        this.root = live.panel('Where does it break?', live.fold('How to read it', hint),
            live.div('live-controls', this.problem), this.question,
            live.div('live-drawings', this.drawing.svg, beside, this.poster),
            live.div('live-controls live-turned', this.knob, this.at), this.digits);
        this.complain = live.failure(this);
        this.move = live.newest((power) => this.show(power), this.complain);
        live.caption(image).after(this.root);
        live.stillOf(image);
        live.caption(image).classList.add('live-still');
        live.seen(this.root, () => (this.ready ??= this.start().catch(this.complain)));
    }

    async start() {
        const answer = await live.ask('sweeps');
        const ranges = live.rows(answer, 'range');
        this.problems = live.lines(answer.text).map((problem, index) => ({ ...problem, ...ranges[index] }));
        this.problem.append(...this.problems.map(({ name }, value) => live.element('option', { value }, name)));
        await this.choose();
    }

    get now() {
        return this.problems[this.problem.value];
    }

    power(place) {
        return this.now.first + this.now.step * place;
    }

    place(power) {
        return Math.round((power - this.now.first) / this.now.step);
    }

    // Another problem: its errors, its question, and the knob where it is harmless.
    async choose() {
        const { now } = this;
        this.errors = await live.ask(`sweep ${now.name}`);
        this.errors.yours = (await this.askYours(now).catch(() => undefined))?.yours;
        delete this.root.dataset.error;
        this.knob.max = this.place(now.last);
        this.knob.setAttribute('aria-label', now.parameter);
        now.question ??= this.ask(now);
        this.question.replaceChildren(now.question);
        await this.turn(this.place(now.harmless));
    }

    // The errors of the reader's own formula, if the exercise is done.
    async askYours({ name, stage, exercise }) {
        if (!live.yours?.[stage]?.includes(exercise)) {
            return undefined;
        }
        const { text, count, given } = await live.ask(`sweep-questions ${name}`);
        const post = await live.start(`yours-${stage}.js`);
        const end = setTimeout(() => post.stop('no end within 10 seconds'), 10_000);
        try {
            const { answers } = await post({ request: `${exercise} answers ${text}`, numbers: [...count, ...given] });
            return await live.ask(`sweep-errors ${name}`, [...answers]);
        } finally {
            clearTimeout(end);
            post.stop();
        }
    }

    // A prediction first, by the knob; then the protocol's curve and digits show.
    ask(problem) {
        const isLost = problem.unit === 'ulp' ? 'has lost half of its digits' : 'is off by half a radius';
        const text = `From which power of ten on is the answer of the protocol’s formula lost, because it ${isLost}? It computes ${problem.computes}. Turn the knob to your guess.`;
        return live.question(text, ['it breaks here', 'it never breaks'], (never) => {
            problem.isKnown = true;
            return this.verdict(never ? Infinity : this.power(this.knob.value));
        });
    }

    // Turns the knob to where it breaks.
    verdict(guess) {
        const [breaks] = this.errors.breaks;
        if (breaks === undefined) {
            this.turn(this.knob.value);
            return `${guess === Infinity ? 'Yes' : 'No'}, it never does. The problem itself loses the digits: the band rises with the curves.`;
        }
        const at = this.place(breaks);
        this.turn(at);
        const { protocol, allowed, lost, powers } = this.errors;
        // It may break on both sides of the harmless one.
        const isLost = (error) => error > lost[0];
        const isNear = powers.some((power, index) => index && isLost(protocol[index]) !== isLost(protocol[index - 1]) && Math.abs(guess - power) <= 0.5);
        return `${isNear ? 'Yes, nearly' : 'No'}: at 10 to the ${breaks}, to which the knob has moved. There it ${this.off(protocol[at])}, and the problem allows ${this.count(allowed[at])}.`;
    }

    count(error) {
        const [digits, power] = error.toExponential(error < 1 ? 1 : 3).split('e').map(Number);
        const isPlain = error === 0 || (power >= -3 && power < 6);
        return `${isPlain ? error.toLocaleString('en', { maximumSignificantDigits: 2 }) : `${digits}·${live.Extremes.ten(power)}`} ${this.now.unit}`;
    }

    off(error) {
        return Number.isFinite(error) ? `is off by ${this.count(error)}` : 'finds nothing';
    }

    turn(place) {
        this.knob.value = Math.min(Math.max(place, 0), this.knob.max);
        return this.move(this.power(Number(this.knob.value)));
    }

    async show(power) {
        const { now } = this;
        const answer = await live.ask(`sweep ${now.name}`, [power]);
        this.root.toggleAttribute('data-asked', !now.isKnown);
        this.at.value = `${now.parameter}: ${answer.value[0]}`;
        this.knob.setAttribute('aria-valuetext', this.at.value);
        this.draw(power);
        live.paint(this.canvas, answer);
        this.canvas.setAttribute('aria-label', `${now.shows} Left by the protocol’s formula, right by ours.`);
        this.shown.textContent = now.shows;
        const [exact, theirs, ours] = answer.text.split('\n');
        const row = (name, number, right, error) => [
            live.element('dt', {}, name),
            live.element('dd', {}, live.element('code', {}, number.slice(0, right), live.element('mark', {}, number.slice(right))), ` ${error}`),
        ];
        const error = (index) => this.off(answer.errors[index]);
        this.digits.replaceChildren(
            ...row('exact', exact, exact.length, `the problem allows ${this.count(answer.allowed[0])}`),
            ...(now.isKnown ? row('protocol', theirs, answer.right[0], error(0)) : row('protocol', '', 0, 'after your guess')),
            ...row('ours', ours, answer.right[1], error(1)));
        this.poster.remove();
        this.root.dataset.drawn = '';
    }

    draw(power) {
        const { area, none } = live.Extremes;
        const { now, errors } = this;
        const [least, most] = live.Extremes.errors[now.unit];
        const pen = new live.Pen(area);
        const top = none - 0.5;
        const x = (at) => (10 * (at - now.first)) / (now.last - now.first);
        const y = (error) => (Number.isFinite(error) ? ((Math.min(Math.max(Math.log10(error), least), most) - least) / (most - least)) * top : none);
        const places = (list) => list.map((error, index) => [x(errors.powers[index]), y(error)]);
        const at = this.place(power);
        pen.line([x(power), 0], [x(power), none], 'ink');
        pen.path([[0, 0], ...places(errors.allowed), [10, 0]], 'pale a', true);
        const levels = now.unit === 'ulp'
            ? { '1 ulp': 1, '10⁴': 1e4, half: errors.lost[0], '10¹²': 1e12, '10¹⁶': 1e16, none: Infinity }
            : { '10⁻¹⁶': 1e-16, '10⁻¹²': 1e-12, '10⁻⁸': 1e-8, '10⁻⁴': 1e-4, '½ radius': errors.lost[0], none: Infinity };
        pen.grid(1, Object.entries(levels).map(([words, error]) => [y(error), words]));
        const steps = Math.abs(now.last - now.first) > 50 ? 100 : 4;
        const ticks = errors.powers.filter((tick) => tick % steps === 0);
        pen.grid(0, ticks.map((tick) => [x(tick), live.Extremes.ten(tick)]));
        if (errors.yours) {
            pen.path(places(errors.yours), 'ink wide');
            pen.text([5, none - 1.6], 'yours', '', 'middle');
        }
        const curve = (list, kind, words, height) => {
            pen.path(places(list), kind);
            pen.dot([x(power), y(list[at])], kind, 6);
            pen.text([0.2, height], words, kind);
        };
        if (now.isKnown) {
            curve(errors.protocol, 'b', 'protocol', none - 1.6);
        }
        curve(errors.ours, 'c', 'ours', none - 2.2);
        pen.text([0.2, none - 2.8], 'allowed', 'a');
        this.drawing.show(pen);
        this.drawing.svg.setAttribute('aria-label', `Errors in ${now.unit} against the ${now.parameter}; here ours ${this.off(errors.ours[at])}`);
    }

    // A power of ten.
    static ten(power) {
        return `10${[...String(power)].map((digit) => '⁰¹²³⁴⁵⁶⁷⁸⁹'[digit] ?? '⁻').join('')}`;
    }
};

live.extremes = live.images('img[src$="/a04-intersections-sphere-far.svg"]')
    .filter(() => document.querySelector('main #where-does-it-break'))
    .map((image) => new live.Extremes(image))[0];
