// Error against run time: a work-precision diagram that the page measures, by the code of the reports.
live.Measure = class {
    static pixels = ['one in the middle', 'random', 'regular', 'stratified', 'n rooks', 'R2'];
    static pictures = ['one in the middle', 'random', 'regular', 'stratified', 'adaptive'];
    // What is measured: its name in the module, its name for the reader, and the recorded experiment.
    static subjects = [
        ['a05-lighting-phong', 'phong, a picture', 'a05.phong'],
        ['samples-curved-edge', 'the edge of a disc', 'a03.samples-curved-edge'],
        ['samples-level-edge', 'a level edge', 'a03.samples-level-edge'],
        ['a03-rays-cameras-striped-sky', 'striped-sky, a picture', ''],
        ['file', 'your scene, from the editor', ''],
    ];

    constructor(before) {
        this.subject = live.element('select', { 'aria-label': 'what is measured', onchange: () => this.choose() },
            ...live.Measure.subjects.map(([value, words]) => live.element('option', { value }, words)));
        this.methods = live.element('span', { className: 'live-methods', role: 'group', 'aria-label': 'methods' });
        this.question = live.element('div', { className: 'live-question' });
        this.start = live.button('measure', () => this.run().catch(live.complain(this.status)));
        this.halt = live.button('stop', () => this.stop());
        this.bar = live.element('progress', { max: 1, hidden: true, 'aria-label': 'measured' });
        this.status = live.element('output');
        this.verdict = live.element('div', { className: 'live-verdict', role: 'status' });
        this.slopes = live.element('p', { className: 'live-status' });
        this.shown = live.element('figure', { className: 'live-shown', hidden: true });
        this.canvas = live.element('canvas', { role: 'img', 'aria-label': 'the picture of the point, and its error enlarged' });
        this.caption = live.element('figcaption');
        this.shown.append(this.canvas, this.caption);
        this.diagram = new live.WorkPrecision(
            live.newest((point) => this.show(point), ({ message }) => (this.caption.textContent = message)),
            live.newest((error) => this.answer(error), ({ message }) => this.say(message)));
        const hint = 'Farther left is faster, farther down is more exact. Thin: recorded on another machine. A bar is an interval of 95 %; large marks are on the Pareto front. A browser tells the time on the wall, in which your machine may do other work, too. '
            + 'Drag the line to the error that you want, or move it by the arrow keys; point at a mark, or go to it by Tab and arrow keys, to see its picture.';
        this.root = live.panel('Which method reaches your error soonest, here?', hint,
            live.element('div', { className: 'live-controls' }, this.subject, ' ', this.methods),
            this.question,
            live.element('div', { className: 'live-controls' }, this.start, ' ', this.halt, ' ', this.bar, ' ', this.status),
            live.element('div', { className: 'live-drawings' }, this.diagram.svg),
            this.verdict, this.slopes, this.shown);
        before.before(this.root);
        addEventListener('hashchange', () => this.open());
        this.choose();
        this.open();
    }

    // The scene of the editor's link.
    open() {
        if (location.hash.startsWith('#scene=')) {
            this.subject.value = 'file';
            this.choose();
            this.root.scrollIntoView();
        }
    }

    // A subject has its methods, its question and its recorded curves.
    choose() {
        this.end();
        const { value } = this.subject;
        this.points = [];
        const names = value.startsWith('samples-') ? live.Measure.pixels : live.Measure.pictures;
        this.methods.replaceChildren(...names.map((name) => live.element('label', {},
            live.element('input', { type: 'checkbox', checked: true, value: name, onchange: () => this.draw() }), live.WorkPrecision.key(name), name)));
        const [, , recorded] = live.Measure.subjects.find(([name]) => name === value);
        this.recorded = (live.recorded[recorded] ?? []).map(([method, parameter, error, seconds]) => ({ method, parameter, error, seconds }));
        this.ask(names);
        this.say('');
        this.slopes.textContent = '';
        this.shown.hidden = true;
        this.status.value = '';
        const [, scene] = location.hash.split('#scene=');
        if (value === 'file' && !scene) {
            this.status.replaceChildren('Write a scene in ', live.element('a', { href: 'scene-editor.html' }, 'the editor'), ', and follow its link “how many samples does it need?”.');
        }
        this.name = value === 'file' ? scene && `file\n${decodeURIComponent(scene)}` : value;
        this.start.disabled = true;
        this.draw();
    }

    // A guess first.
    ask(names) {
        this.guess = undefined;
        const buttons = names.map((name) => live.button(name, () => {
            this.guess = name;
            buttons.forEach((button) => button.classList.toggle('live-chosen', button.textContent === name));
            this.start.disabled = !this.name;
        }));
        this.question.replaceChildren('Your guess: which of them comes down to an error of 1/510, half a grey level, soonest on your machine? ', ...buttons);
    }

    chosen() {
        return [...this.methods.querySelectorAll('input:checked')].map(({ value }) => value);
    }

    async run() {
        const methods = this.chosen();
        if (!methods.length) {
            this.status.value = 'choose a method';
            return;
        }
        this.end();
        this.points = [];
        this.shown.hidden = true;
        this.root.dataset.state = 'measuring';
        [this.halt.disabled, this.start.disabled, this.bar.hidden] = [false, true, false];
        this.bar.removeAttribute('value');
        this.status.value = 'starting …';
        const run = (this.running = { began: performance.now() });
        // A worker of its own, so that other pictures of the page do not wait.
        const post = await live.start();
        if (run !== this.running) {
            post.stop('stopped');
            return;
        }
        this.post = post;
        const request = async (words, numbers = []) => {
            const answer = await post({ request: `measure ${words}`, numbers });
            if (run !== this.running) {
                throw new Error('stopped');
            }
            return answer;
        };
        this.tick = await post({ tick: true });
        // So long a time is known to 4 %: it is off by one step of the clock at each end.
        this.least = Math.max(1, 50 * this.tick);
        try {
            let answer = await request(`begin ${methods}|${this.name}`, [this.least / 1000]);
            this.status.value = 'rendering the picture to compare with …';
            while (!answer.prepared[0]) {
                answer = await request('prepare');
                this.progress(answer, 'errors');
            }
            while (!answer.measured[0]) {
                const { milliseconds } = await request('run');
                answer = await request('took', [milliseconds / 1000]);
                this.take(answer);
                this.progress(answer, 'times');
            }
            this.rest(`measured in ${live.time((performance.now() - run.began) / 1000)}, ${this.rounds} rounds`);
        } catch (error) {
            if (run === this.running) {
                this.rest(error.message);
            }
        }
    }

    progress({ progress: [done, all] }, what) {
        const seconds = ((performance.now() - this.running.began) / 1000) * (all / done - 1);
        this.bar.value = done / all;
        this.status.value = `measuring ${what}: ${Math.ceil(seconds)} s left`;
    }

    // Stops at once while errors are computed, of which nothing is shown; then at the end of this turn, so that the
    // module can show the pictures of the points.
    stop() {
        if (this.points.length === 0) {
            this.end();
        }
        this.rest(`stopped after ${live.count(this.rounds, 'round')}`);
    }

    // Nothing is measured any longer.
    rest(words) {
        this.running = undefined;
        this.status.value = words;
        this.bar.hidden = true;
        this.root.dataset.state = 'measured';
        [this.halt.disabled, this.start.disabled] = [true, false];
    }

    end() {
        this.running = undefined;
        this.post?.stop('stopped');
        this.post = undefined;
        this.bar.hidden = true;
        this.halt.disabled = true;
        this.rounds = 0;
        this.root.dataset.state = 'recorded';
    }

    // The points that have a time.
    take(answer) {
        const lines = answer.text.split('\n').map((line) => line.split('\t'));
        const counts = {};
        this.points = answer.curve.map((curve, i) => {
            const index = (counts[curve] = (counts[curve] ?? -1) + 1);
            const [method] = lines[curve];
            const point = { curve, index, method, front: answer.front[i] === 1 };
            const [parameter, error, seconds] = ['parameter', 'error', 'seconds'].map((name) => answer[name][i]);
            Object.assign(point, { parameter, error, seconds, work: answer.work[i],
                errorLow: answer.error_low[i], errorHigh: answer.error_high[i],
                secondsLow: answer.seconds_low[i], secondsHigh: answer.seconds_high[i] });
            point.words = `${method}, ${live.count(parameter, 'sample')} per pixel: error ${live.digits(error)} (${live.digits(point.errorLow)} to ${live.digits(point.errorHigh)}), `
                + `${live.time(seconds)} (${live.time(point.secondsLow)} to ${live.time(point.secondsHigh)})${point.front ? '; on the Pareto front' : ''}`;
            return point;
        }).filter(({ seconds }) => seconds > 0);
        [this.rounds] = answer.rounds;
        this.isTooShort = answer.too_short[0] === 1;
        this.slopes.textContent = lines.filter(([, slope]) => slope).map(([method, slope]) => `${method}: ${slope}`).join('; ');
        this.draw();
    }

    draw() {
        const chosen = this.chosen();
        const drawn = (list) => list.filter(({ method }) => chosen.includes(method));
        this.diagram.draw(drawn(this.recorded), drawn(this.points));
    }

    // Which method reaches an error soonest, with how many samples, and how sure that is.
    async answer(error) {
        if (!this.post || !this.points.length) {
            return this.say(`Which method reaches an error of ${live.digits(error)} soonest on this machine? Guess above, and measure.`);
        }
        const { curve, ties: [ties], ...reach } = await this.post({ request: 'measure soonest', numbers: [error] });
        const names = new Map(this.points.map((point) => [point.curve, point.method]));
        const costs = curve.map((index, i) => {
            const [low, high] = [reach.seconds_low[i], reach.seconds_high[i]].map((end) => (end === Infinity ? 'unknown' : live.time(end)));
            return `${names.get(index)}: ${live.count(reach.parameter[i], 'sample')} per pixel, ${live.time(reach.seconds[i])} (${low} to ${high})`;
        });
        const soonest = curve.slice(0, ties).map((index) => names.get(index));
        const verdict = soonest.includes(this.guess) ? 'as you guessed' : `you guessed ${this.guess}`;
        const others = [...names].filter(([index]) => !curve.includes(index)).map(([, name]) => name);
        const sure = {
            0: 'no measured method reaches it.',
            1: `${soonest[0]} is soonest (${verdict}): its interval of 95 % lies apart from the others.`,
        }[ties] ?? `${soonest.join(' or ')} (${verdict}): their times differ by less than a factor of 1.2, or than their intervals.`;
        return this.say(`An error of ${live.digits(error)}: ${sure}`, costs, [...(others.length ? [`Not reached by ${others.join(', ')}.`] : []), ...this.doubts()].join(' '));
    }

    // A verdict, what the methods cost, and what is left to say.
    say(verdict, costs = [], rest = '') {
        this.verdict.replaceChildren(live.element('strong', {}, verdict), live.element('ul', {}, ...costs.map((cost) => live.element('li', {}, cost))), rest);
    }

    // What makes the times less sure.
    doubts() {
        const doubts = [];
        if (this.rounds < 6) {
            doubts.push(`After ${live.count(this.rounds, 'round')}: an interval of 95 % takes six.`);
        }
        if (this.isTooShort) {
            doubts.push(`The clock of this browser has steps of ${live.digits(this.tick)} ms, too coarse for the shortest runs.`);
        } else if (this.tick >= 1) {
            doubts.push(`The clock of this browser has steps of ${live.digits(this.tick)} ms, so each run is repeated for ${live.digits(this.least)} ms.`);
        }
        return doubts;
    }

    // The picture of a point, and its error.
    async show(point) {
        const post = this.post;
        if (!post) {
            return;
        }
        const answer = await post({ request: 'measure picture', numbers: [point.curve, point.index] });
        this.shown.hidden = false;
        live.paint(this.canvas, answer);
        this.caption.textContent = `${point.words}. At the right its error, ${answer.factor[0]} times: grey is right, lighter too bright, darker too dark.`;
    }
};

live.measure = live.tool('one-example', (heading) => new live.Measure(heading));
