// Where does it break? One number of a problem goes from harmless to extreme: the errors of the protocol's formula
// and of ours over the whole range, and under the knob all digits and a picture.
live.Extremes = class {
    // Where the powers of ten and the errors lie in the drawing: from below 1 ulp to no answer.
    static area = { x: [-1.5, 10.8], y: [-1.1, 7.3] };
    static errors = [-1, 17];
    static none = 6.8;

    // Takes the place of the picture that shows recorded errors.
    constructor(image) {
        this.problem = live.element('select', { 'aria-label': 'problem', onchange: () => this.choose().catch(this.complain) });
        this.drawn = live.svg('g', {});
        this.handle = live.svg('circle', { r: 12, class: 'live-handle' });
        this.svg = live.svg('svg', { viewBox: `0 0 ${live.Pen.width} ${new live.Pen(live.Extremes.area).height}`, role: 'img' }, this.drawn, this.handle);
        this.knob = live.element('input', { type: 'range', min: 0, oninput: () => this.turn(Number(this.knob.value)) });
        this.at = live.element('output');
        this.question = live.element('div', { className: 'live-question' });
        this.digits = live.element('dl', { className: 'live-digits' });
        this.canvas = live.element('canvas', { width: 248, height: 120, role: 'img' });
        this.shown = live.element('figcaption');
        const beside = live.element('div', { className: 'live-beside' }, this.canvas, live.element('div', { className: 'live-both' }, live.element('span', {}, 'protocol’s'), live.element('span', {}, 'ours')), this.shown);
        const hint = 'The band is what the problem allows: its condition times half an ulp. Higher up, a formula loses digits that it could have kept. At the line “half” about eight of sixteen digits are wrong; at “none” there is no answer.';
        this.root = live.panel('Where does it break?', hint,
            live.element('div', { className: 'live-controls' }, live.element('label', {}, 'turn ', this.problem)), this.question,
            live.element('div', { className: 'live-drawings' }, this.svg, beside),
            live.element('div', { className: 'live-controls live-turned' }, this.knob, this.at), this.digits);
        this.complain = ({ message }) => (this.root.dataset.error = message);
        this.move = live.newest((power) => this.show(power), this.complain);
        live.drag(this.handle, (event) => {
            const { x, width } = this.svg.getBoundingClientRect();
            const [place] = new live.Pen(live.Extremes.area).from([((event.clientX - x) * live.Pen.width) / width, 0]);
            this.turn(Math.round((place / 10) * this.knob.max));
        });
        live.caption(image).after(this.root);
        live.stillOf(image);
        live.caption(image).classList.add('live-still');
        this.cases = new live.Cases(this.root);
        // The module is loaded when the reader is about to see the figure.
        const seen = new IntersectionObserver(([{ isIntersecting }]) => {
            if (isIntersecting) {
                seen.disconnect();
                this.ready = this.start().catch(this.complain);
            }
        }, { rootMargin: '200px' });
        seen.observe(this.root);
    }

    async start() {
        const { text, ...lists } = await live.ask('sweeps');
        this.problems = text.split('\n').map((line, index) => {
            const [name, parameter, computes, shows, stage, cases, exercise] = line.split('\t');
            const [first, last, harmless, step] = ['first', 'last', 'harmless', 'step'].map((list) => lists[list][index]);
            return { name, parameter, computes, shows, stage, cases, exercise, first, last, harmless, step: last < first ? -step : step };
        });
        this.problem.append(...this.problems.map(({ parameter }, value) => live.element('option', { value }, parameter)));
        await this.choose();
    }

    get now() {
        return this.problems[this.problem.value];
    }

    power(place) {
        return this.now.first + this.now.step * place;
    }

    // Another problem: its errors, its question, and the knob where it is harmless.
    async choose() {
        const { now } = this;
        this.errors = await live.ask(`sweep ${now.name}`);
        this.errors.yours = (await this.askYours(now).catch(() => undefined))?.yours;
        delete this.root.dataset.error;
        this.knob.max = Math.round((now.last - now.first) / now.step);
        this.knob.setAttribute('aria-label', now.parameter);
        this.cases.stage.value = now.stage;
        this.cases.filter.value = now.cases;
        now.asked ??= 'yes';
        this.ask();
        await this.turn(Math.round((now.harmless - now.first) / now.step));
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
    ask() {
        const { now } = this;
        const verdict = live.element('output');
        const answer = (guess) => {
            now.asked = 'no';
            verdict.value = this.verdict(guess);
            buttons.forEach((button) => (button.disabled = true));
            this.turn(Number(this.knob.value));
        };
        const buttons = [
            live.button('it breaks here', () => answer(this.power(this.knob.value))),
            live.button('it never breaks', () => answer(undefined)),
        ];
        this.question.replaceChildren(`At which power of ten has the protocol’s formula lost half of its digits? It computes ${now.computes}. Turn the knob to your guess. `, ...buttons, verdict);
        if (now.asked === 'no') {
            answer();
            verdict.value = this.verdict();
        }
    }

    verdict(guess) {
        const [breaks] = this.errors.breaks;
        if (breaks === undefined) {
            return 'It never does. The problem itself loses the digits: the band rises with the curves.';
        }
        const off = guess === undefined ? Infinity : Math.abs(guess - breaks);
        const start = off <= 0.5 ? 'Yes, nearly: at' : 'At';
        const [ours, allowed] = ['ours', 'allowed'].map((list) => this.errors[list][Math.round((breaks - this.now.first) / this.now.step)]);
        const we = ours > this.errors.broken[0] ? 'So has ours, by the same roundings' : `Ours ${live.Extremes.ulps(ours)} there`;
        return `${start} 10 to the ${breaks}. ${we}; the problem alone allows ${live.Extremes.count(allowed)}.`;
    }

    static count(error) {
        return `${Number(error.toPrecision(2)).toLocaleString('en', error < 1e6 ? { maximumSignificantDigits: 2 } : { notation: 'scientific' })} ulp`;
    }

    static ulps(error) {
        return Number.isFinite(error) ? `is off by ${live.Extremes.count(error)}` : 'finds nothing';
    }

    turn(place) {
        this.knob.value = Math.min(Math.max(place, 0), this.knob.max);
        return this.move(this.power(Number(this.knob.value)));
    }

    async show(power) {
        const { now } = this;
        const answer = await live.ask(`sweep ${now.name}`, [power]);
        const isAsked = now.asked === 'yes';
        this.root.toggleAttribute('data-asked', isAsked);
        this.at.value = `${now.parameter}: ${answer.value[0]}`;
        this.knob.setAttribute('aria-valuetext', this.at.value);
        this.draw(power, isAsked);
        live.paint(this.canvas, answer);
        this.canvas.setAttribute('aria-label', `${now.shows} Left by the protocol’s formula, right by ours.`);
        this.shown.textContent = now.shows;
        const [exact, theirs, ours] = answer.text.split('\n');
        const row = (name, number, right, error) => [
            live.element('dt', {}, name),
            live.element('dd', {}, live.element('code', {}, number.slice(0, right), live.element('mark', {}, number.slice(right))), ` ${error}`),
        ];
        const error = (index) => live.Extremes.ulps(answer.errors[index]);
        this.digits.replaceChildren(
            ...row('exact', exact, exact.length, `the problem allows ${live.Extremes.count(answer.allowed[0])}`),
            ...(isAsked ? row('protocol', '', 0, 'after your guess') : row('protocol', theirs, answer.right[0], error(0))),
            ...row('ours', ours, answer.right[1], error(1)));
        this.root.dataset.drawn = '';
    }

    draw(power, isAsked) {
        const { area, errors: [least, most], none } = live.Extremes;
        const { now, errors } = this;
        const pen = new live.Pen(area);
        const top = none - 0.5;
        const x = (at) => (10 * (at - now.first)) / (now.last - now.first);
        const y = (error) => (Number.isFinite(error) ? ((Math.min(Math.max(Math.log10(error), least), most) - least) / (most - least)) * top : none);
        const places = (list) => [...list].map((error, index) => [x(errors.powers[index]), y(error)]);
        const level = (error, words) => {
            pen.line([0, y(error)], [10, y(error)], 'thin');
            pen.text([-0.15, y(error) - 0.42], words, '', 'end');
        };
        pen.path([[0, 0], ...places(errors.allowed), [10, 0]], 'pale a', true);
        level(1, '1 ulp');
        level(1e4, '10⁴');
        level(errors.broken[0], 'half');
        level(1e12, '10¹²');
        level(1e16, '10¹⁶');
        level(Infinity, 'none');
        const steps = Math.abs(now.last - now.first) > 50 ? 100 : 4;
        for (let at = Math.ceil(Math.min(now.first, now.last) / steps) * steps; at <= Math.max(now.first, now.last); at += steps) {
            pen.line([x(at), 0], [x(at), -0.12], 'ink');
            pen.text([x(at), -1.05], live.Extremes.ten(at), '', 'middle');
        }
        if (errors.yours) {
            pen.path(places(errors.yours), 'ink wide');
            pen.text([5, none - 1.6], 'yours', '', 'middle');
        }
        if (!isAsked) {
            pen.path(places(errors.protocol), 'b');
        }
        pen.path(places(errors.ours), 'c');
        pen.line([x(power), 0], [x(power), none], 'ink');
        const [at] = [Math.round((power - now.first) / now.step)];
        pen.dot([x(power), y(errors.ours[at])], 'c', 6);
        if (!isAsked) {
            pen.dot([x(power), y(errors.protocol[at])], 'b', 6);
            pen.text([0.2, none - 1.6], 'protocol', 'b');
        }
        pen.text([0.2, none - 2.2], 'ours', 'c');
        pen.text([0.2, none - 2.8], 'allowed', 'a');
        this.drawn.innerHTML = pen.shapes.join('');
        const [cx, cy] = pen.to([x(power), 0]);
        this.handle.setAttribute('cx', cx);
        this.handle.setAttribute('cy', cy);
        this.svg.setAttribute('aria-label', `Errors in ulp against the ${now.parameter}; here ours ${live.Extremes.ulps(errors.ours[at])}`);
    }

    // A power of ten.
    static ten(power) {
        return `10${[...String(power)].map((digit) => '⁰¹²³⁴⁵⁶⁷⁸⁹'[digit] ?? '⁻').join('')}`;
    }
};

live.extremes = live.images('img[src$="/a04-intersections-sphere-far.svg"]')
    .filter(() => document.querySelector('main #where-does-it-break'))
    .map((image) => new live.Extremes(image))[0];
