// What the reader starts and stops: its buttons, its bar, what it says, and a module of its own, so that other
// figures do not wait. `work` resolves to its last words.
live.Run = class {
    constructor(name, work) {
        Object.assign(this, { work, module: new live.Module() });
        this.start = live.button(name, () => this.begin());
        this.halt = live.element('button', { type: 'button', disabled: true, onclick: () => this.stop() }, 'stop');
        this.bar = live.element('progress', { value: 0, hidden: true, 'aria-label': 'done' });
        this.status = live.element('output');
        this.controls = [this.start, ' ', this.halt, ' ', this.bar, ' ', this.status];
    }

    begin() {
        this.running = this.go();
        return this.running;
    }

    async go() {
        this.began = performance.now();
        this.stopped = undefined;
        this.swap(this.start, this.halt);
        this.bar.hidden = false;
        this.bar.removeAttribute('value');
        this.status.value = 'starting …';
        this.status.value = await this.work().catch(({ message }) => message);
        this.swap(this.halt, this.start);
        this.bar.hidden = true;
    }

    // Ends one button and makes the other one ready, which takes the focus over.
    swap(ended, ready) {
        const hasFocus = ended.matches(':focus');
        [ended.disabled, ready.disabled] = [true, false];
        if (hasFocus) {
            ready.focus();
        }
    }

    async ask(request, numbers) {
        const answer = await this.module.ask(request, numbers);
        if (this.stopped) {
            throw new Error(this.stopped);
        }
        return answer;
    }

    // Stops at the end of a request whose module is kept, and otherwise at once.
    async stop() {
        if (this.halt.disabled) {
            return;
        }
        this.stopped = 'stopped';
        if (!this.isKept) {
            await this.module.stop(this.stopped);
        }
        await this.running;
    }

    get seconds() {
        return (performance.now() - this.began) / 1000;
    }

    // Measures in turns: the module runs the methods, each for at least so many milliseconds, and the page has the
    // clock. `take` gets what is measured so far.
    async turns(request, numbers, least, take) {
        this.rounds = 0;
        this.isKept = false;
        this.tick = await this.module.post({ tick: true });
        // So long a time is known to 4 %: it is off by one step of the clock at each end.
        this.least = Math.max(least, 50 * this.tick);
        const progress = ({ progress: [done, all] }, words) => {
            this.bar.value = done / all;
            this.status.value = `measuring ${words}: ${Math.ceil(this.seconds * (all / done - 1))} s left`;
        };
        let answer = await this.ask(`measure begin ${request}`, [this.least / 1000, ...numbers]);
        while (!answer.prepared[0]) {
            answer = await this.ask('measure prepare');
            progress(answer, 'errors');
        }
        // From here on the module can show the pictures of what is measured, also after a stop.
        this.isKept = true;
        while (!answer.measured[0]) {
            const { milliseconds } = await this.ask('measure run');
            answer = await this.ask('measure took', [milliseconds / 1000]);
            [[this.rounds], [this.isTooShort]] = [answer.rounds, answer.too_short];
            take(answer, live.lines(answer.text, 'method', 'slope', 'quotient'));
            progress(answer, 'times');
        }
        return `measured in ${live.time(this.seconds)}, ${this.rounds} rounds`;
    }

    // What makes the times less sure.
    doubts() {
        const clock = `The clock of this browser has steps of ${live.digits(this.tick)} ms`;
        return [
            this.rounds < 6 && `After ${live.count(this.rounds, 'round')}: an interval of 95 % takes six.`,
            this.isTooShort ? `${clock}, too coarse for the shortest runs.`
                : this.tick >= 1 && `${clock}, so each run is repeated for ${live.digits(this.least)} ms.`,
        ].filter(Boolean);
    }
};
