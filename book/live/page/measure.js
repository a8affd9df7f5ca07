// Error against run time: a work-precision diagram that the page measures, by the code of the reports.
live.Measure = class {
    // What is measured: its name in the module, and its name for the reader.
    static subjects = [
        ['a05-lighting-phong', 'phong, a picture'],
        ['samples-curved-edge', 'the edge of a disc'],
        ['samples-level-edge', 'a level edge'],
        ['a03-rays-cameras-striped-sky', 'striped-sky, a picture'],
        ['file', 'your scene, from the editor'],
    ];
    constructor(before) {
        this.subject = live.select('what is measured', live.Measure.subjects, () => this.choose());
        this.methods = live.element('span', { role: 'group', 'aria-label': 'methods' });
        this.question = live.element('div');
        this.run = new live.Run('measure', () => this.measure());
        this.verdict = live.element('div', { className: 'live-verdict', role: 'status' });
        this.slopes = live.element('p', { className: 'live-status' });
        this.canvas = live.element('canvas', { role: 'img', 'aria-label': 'the picture of the point, and its error enlarged' });
        this.caption = live.element('figcaption');
        this.shown = live.element('figure', { className: 'live-shown', hidden: true }, this.canvas, this.caption);
        this.diagram = new live.WorkPrecision(
            live.newest((point) => this.show(point), live.complain(this.caption)),
            live.newest((error) => this.answer(error), ({ message }) => this.say(message)));
        const hint = 'Farther left is faster, farther down more exact. Thin: recorded on another machine; before your guess only what one sample per pixel costs. A bar is an interval of 95 %, of a time in this run; large marks are on the Pareto front. A browser tells the time on the wall, in which your machine may do other work, too. '
            + 'Drag the line to the error that you want, or move it by the arrow keys; point at a mark, or go to it by Tab and arrow keys, to see its picture.';
        this.root = live.panel('What reaches your error soonest?', live.fold('How to read it', hint),
            live.div('live-controls', this.subject, ' ', this.methods),
            this.question,
            live.div('live-controls', ...this.run.controls),
            live.div('live-drawings', this.diagram.svg, live.div('live-told', this.verdict, this.slopes), this.shown));
        before.before(this.root);
        addEventListener('hashchange', () => this.open());
        this.choose();
        this.open();
    }

    // The scene of the editor's link.
    open() {
        if (live.linkedScene()) {
            this.subject.value = 'file';
            this.choose();
            this.root.scrollIntoView();
        }
    }

    // A subject has its methods, its question and its recorded curves.
    async choose() {
        await this.run.forget();
        const { value } = this.subject;
        this.clear();
        const unknown = value.startsWith('samples-') ? ['adaptive'] : ['n rooks', 'R2'];
        const names = live.WorkPrecision.methods.filter((name) => !unknown.includes(name));
        this.methods.replaceChildren(...names.map((name) => live.element('label', {},
            live.element('input', { type: 'checkbox', checked: true, value: name, onchange: () => this.run.forget().then(() => this.draw()) }), live.WorkPrecision.key(name), name)));
        this.recorded = live.recorded[value] ?? [];
        this.name = value === 'file' ? live.linkedScene() : value;
        this.run.status.replaceChildren(...(this.name ? [] : ['Write a scene in ', live.element('a', { href: 'scene-editor.html' }, 'the editor'), ', and follow its link “how many samples does it need?”.']));
        this.run.start.hidden = !this.name;
        this.guess = undefined;
        this.question.replaceChildren(live.question('Your guess: which one comes down to an error of 1/510, half a grey level, soonest on your machine?', names, (index) => {
            this.guess = names[index];
            if (this.name) {
                this.run.status.value = '';
            }
            this.draw();
            return this.points.length ? 'See below.' : 'Measure, and see.';
        }));
        this.draw();
    }

    // Nothing is measured.
    clear() {
        this.points = [];
        this.slopes.textContent = '';
        this.shown.hidden = true;
    }

    chosen() {
        return [...this.methods.querySelectorAll('input:checked')].map(({ value }) => value);
    }

    async measure() {
        const methods = this.chosen();
        if (!this.guess) {
            return 'Guess first: then you know what you have learned.';
        }
        if (!methods.length) {
            return 'Choose a method.';
        }
        if (!this.run.canGoOn) {
            this.clear();
            this.draw();
        }
        return this.run.turns(`${methods}|${this.name}`, [], 1, (points, lines) => this.take(points, lines));
    }

    // The points that have a time.
    take(points, lines) {
        const counts = {};
        for (const point of points) {
            const { curve, parameter, error, error_low, error_high, seconds, seconds_low, seconds_high, front } = point;
            point.index = counts[curve] = (counts[curve] ?? -1) + 1;
            point.method = lines[curve].method;
            point.words = `${point.method}, ${live.Measure.samples(point.method, parameter)}: error ${live.digits(error)} (${live.digits(error_low)} to ${live.digits(error_high)}), `
                + `${live.time(seconds)} (${live.time(seconds_low)} to ${live.time(seconds_high)})${front ? '; on the Pareto front' : ''}`;
        }
        this.names = lines.map(({ method }) => method);
        this.points = points.filter(({ seconds }) => seconds > 0);
        this.slopes.textContent = lines.filter(({ slope }) => slope).map(({ method, slope }) => `${method}: ${slope}`).join('; ');
        this.draw();
    }

    draw() {
        const chosen = this.chosen();
        const drawn = (list) => list.filter(({ method }) => chosen.includes(method));
        // Of one sample per pixel, with which all but adaptive sampling begin.
        const isFirst = ({ method }, index, list) => method !== 'adaptive' && list.findIndex((point) => point.method === method) === index;
        this.diagram.draw(drawn(this.guess ? this.recorded : this.recorded.filter(isFirst)), drawn(this.points));
    }

    static samples(method, count) {
        return `${live.count(count, 'sample')} per pixel${method === 'adaptive' ? ' in the mean' : ''}`;
    }

    // Which method reaches an error soonest, with how many samples, and how sure that is.
    async answer(error) {
        if (!this.points.length) {
            const rings = this.recorded.length ? 'Each ring is one sample per pixel, as recorded on another machine: farther left is faster, farther down more exact.' : 'Nothing is recorded here: guess, and measure.';
            return this.say(this.guess ? 'Now measure on your machine.' : rings);
        }
        const reach = await this.run.module.ask('measure soonest', [error]);
        const { names } = this;
        const reached = live.rows(reach, 'reach');
        const costs = reached.map(({ curve, parameter, seconds, ...ends }) => {
            const [low, high] = [ends.seconds_low, ends.seconds_high].map((end) => (end === Infinity ? 'unknown' : live.time(end)));
            return `${names[curve]}: ${live.Measure.samples(names[curve], parameter)}, ${live.time(seconds)} (${low} to ${high})`;
        });
        const [ties] = reach.ties;
        const soonest = reached.slice(0, ties).map(({ curve }) => names[curve]);
        const verdict = soonest.includes(this.guess) ? 'as you guessed' : `you guessed ${this.guess}`;
        const others = names.filter((_, index) => reached.every(({ curve }) => curve !== index));
        const sure = {
            0: 'no measured method reaches it.',
            1: `${soonest[0]} is soonest${this.isSure ? '' : ' so far'} (${verdict}): ${reached.length > 1 ? 'the intervals of the others begin more than a factor of 1.2 behind the end of its own' : 'no other method reaches it'}.`,
        }[ties] ?? `not decided between ${soonest.join(', ')} (you guessed ${this.guess}): the interval of ${soonest[0]} overlaps the others, or ends less than a factor of 1.2 before they begin.`;
        return this.say(`An error of ${live.digits(error)}: ${sure}`, costs, [...(others.length ? [`Not reached by ${others.join(', ')}.`] : []), ...this.run.doubts()].join(' '));
    }

    // Whether times have their intervals.
    get isSure() {
        return this.points.length && this.run.rounds >= 6;
    }

    // A verdict, what the methods cost, and what is left to say.
    say(verdict, costs = [], rest = '') {
        this.verdict.replaceChildren(live.element(this.isSure ? 'strong' : 'span', {}, verdict), live.element('ul', {}, ...costs.map((cost) => live.element('li', {}, cost))), rest);
    }

    // The picture of a point, and its error.
    async show(point) {
        const answer = await this.run.module.ask('measure picture', [point.curve, point.index]);
        this.shown.hidden = false;
        live.paint(this.canvas, answer);
        this.caption.textContent = `${point.words}. At the right its error, ${answer.factor[0]} times: grey is right, lighter too bright.`;
    }
};

live.measure = live.tool('one-example', (heading) => new live.Measure(heading));
