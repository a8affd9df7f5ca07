// Error against run time: a work-precision diagram that the page measures, by the code of the reports.
live.Measure = class {
    static pixels = ['one in the middle', 'random', 'regular', 'stratified', 'n rooks', 'R2'];
    static pictures = ['one in the middle', 'random', 'regular', 'stratified', 'adaptive'];
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
        const hint = 'Farther left is faster, farther down is more exact. Thin: recorded on another machine. A bar is an interval of 95 %; large marks are on the Pareto front. A browser tells the time on the wall, in which your machine may do other work, too. '
            + 'Drag the line to the error that you want, or move it by the arrow keys; point at a mark, or go to it by Tab and arrow keys, to see its picture.';
        this.root = live.panel('Which method reaches your error soonest, here?', hint,
            live.div('live-controls', this.subject, ' ', this.methods),
            this.question,
            live.div('live-controls', ...this.run.controls),
            live.div('live-drawings', this.diagram.svg),
            this.verdict, this.slopes, this.shown);
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
        await this.run.stop();
        const { value } = this.subject;
        this.clear();
        const names = value.startsWith('samples-') ? live.Measure.pixels : live.Measure.pictures;
        this.methods.replaceChildren(...names.map((name) => live.element('label', {},
            live.element('input', { type: 'checkbox', checked: true, value: name, onchange: () => this.draw() }), live.WorkPrecision.key(name), name)));
        this.recorded = live.recorded[value] ?? [];
        this.name = value === 'file' ? live.linkedScene() : value;
        this.run.start.disabled = true;
        this.run.status.replaceChildren(...(this.name ? [] : ['Write a scene in ', live.element('a', { href: 'scene-editor.html' }, 'the editor'), ', and follow its link “how many samples does it need?”.']));
        this.guess = undefined;
        this.question.replaceChildren(live.question('Your guess: which of them comes down to an error of 1/510, half a grey level, soonest on your machine?', names, (index) => {
            this.guess = names[index];
            this.run.start.disabled = !this.name;
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
        if (!methods.length) {
            return 'choose a method';
        }
        this.clear();
        this.draw();
        return this.run.turns(`${methods}|${this.name}`, [], 1, (answer, lines) => this.take(answer, lines));
    }

    // The points that have a time.
    take(answer, lines) {
        const counts = {};
        const points = live.rows(answer, 'curve', 'front', 'parameter', 'work', 'error', 'error_low', 'error_high', 'seconds', 'seconds_low', 'seconds_high');
        for (const point of points) {
            const { curve, parameter, error, error_low, error_high, seconds, seconds_low, seconds_high, front } = point;
            point.index = counts[curve] = (counts[curve] ?? -1) + 1;
            point.method = lines[curve].method;
            point.words = `${point.method}, ${live.count(parameter, 'sample')} per pixel: error ${live.digits(error)} (${live.digits(error_low)} to ${live.digits(error_high)}), `
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
        this.diagram.draw(drawn(this.recorded), drawn(this.points));
    }

    // Which method reaches an error soonest, with how many samples, and how sure that is.
    async answer(error) {
        if (!this.points.length) {
            return this.say(`Which method reaches an error of ${live.digits(error)} soonest on this machine? Guess above, and measure.`);
        }
        const reach = await this.run.module.ask('measure soonest', [error]);
        const { names } = this;
        const reached = live.rows(reach, 'curve', 'parameter', 'seconds', 'seconds_low', 'seconds_high');
        const costs = reached.map(({ curve, parameter, seconds, ...ends }) => {
            const [low, high] = [ends.seconds_low, ends.seconds_high].map((end) => (end === Infinity ? 'unknown' : live.time(end)));
            return `${names[curve]}: ${live.count(parameter, 'sample')} per pixel, ${live.time(seconds)} (${low} to ${high})`;
        });
        const [ties] = reach.ties;
        const soonest = reached.slice(0, ties).map(({ curve }) => names[curve]);
        const verdict = soonest.includes(this.guess) ? 'as you guessed' : `you guessed ${this.guess}`;
        const others = names.filter((_, curve) => !reach.curve.includes(curve));
        const sure = {
            0: 'no measured method reaches it.',
            1: `${soonest[0]} is soonest (${verdict}): its interval of 95 % lies apart from the others.`,
        }[ties] ?? `${soonest.join(' or ')} (${verdict}): their times differ by less than a factor of 1.2, or than their intervals.`;
        return this.say(`An error of ${live.digits(error)}: ${sure}`, costs, [...(others.length ? [`Not reached by ${others.join(', ')}.`] : []), ...this.run.doubts()].join(' '));
    }

    // A verdict, what the methods cost, and what is left to say.
    say(verdict, costs = [], rest = '') {
        this.verdict.replaceChildren(live.element('strong', {}, verdict), live.element('ul', {}, ...costs.map((cost) => live.element('li', {}, cost))), rest);
    }

    // The picture of a point, and its error.
    async show(point) {
        const answer = await this.run.module.ask('measure picture', [point.curve, point.index]);
        this.shown.hidden = false;
        live.paint(this.canvas, answer);
        this.caption.textContent = `${point.words}. At the right its error, ${answer.factor[0]} times: grey is right, lighter too bright, darker too dark.`;
    }
};

live.measure = live.tool('one-example', (heading) => new live.Measure(heading));
