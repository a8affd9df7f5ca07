// What the reader starts and stops: its buttons, its bar, what it says, and a module of its own, so that other
// figures do not wait. `work` resolves to its last words.
live.Run = class {
    constructor(name, work) {
        Object.assign(this, { name, work, module: new live.Module(), canGoOn: false });
        this.start = live.button(name, () => this.begin());
        this.halt = live.element('button', { type: 'button', disabled: true, hidden: true, onclick: () => this.stop() }, 'stop');
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
        this.doneBefore = undefined;
        this.swap(this.start, this.halt);
        this.bar.hidden = false;
        this.bar.removeAttribute('value');
        this.status.value = 'starting …';
        this.status.value = await this.work().catch(({ message }) => {
            this.canGoOn &&= message === this.stopped;
            return message;
        });
        this.swap(this.halt, this.start);
        this.bar.hidden = true;
    }

    // Hides one button and shows the other one, which takes the focus over.
    swap(ended, ready) {
        const hasFocus = ended.matches(':focus');
        [ended.disabled, ready.disabled] = [ended.hidden, ready.hidden] = [true, false];
        this.start.textContent = this.canGoOn ? 'go on' : this.name;
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

    // The next start begins anew.
    async forget() {
        await this.stop();
        this.canGoOn = false;
        this.start.textContent = this.name;
    }

    // Measures in turns: the module runs the methods, each for at least so many milliseconds, and the page has the
    // clock. `take` gets what is measured so far. After a stop it goes on where it was.
    async turns(request, numbers, least, take) {
        if (!this.canGoOn) {
            await this.prepare(request, numbers, least);
        }
        // From here on the module can show the pictures of what is measured, also after a stop.
        this.isKept = this.canGoOn = true;
        for (let isMeasured = 0; !isMeasured;) {
            const { milliseconds } = await this.ask('measure run');
            const answer = await this.ask('measure took', [milliseconds / 1000]);
            [[this.rounds], [this.isTooShort], [isMeasured]] = [answer.rounds, answer.too_short, answer.measured];
            take(live.rows(answer, 'point'), live.lines(answer.text));
            this.progress(answer, 'times');
        }
        this.canGoOn = false;
        return `${live.count(this.rounds, 'round')} measured`;
    }

    // What is measured before the turns.
    async prepare(request, numbers, least) {
        this.rounds = 0;
        this.isKept = false;
        this.tick = await this.module.post({ tick: true });
        // So long a time is known to 4 %: it is off by one step of the clock at each end.
        this.least = Math.max(least, 50 * this.tick);
        let answer = await this.ask(`measure begin ${request}`, [this.least / 1000, ...numbers]);
        while (!answer.prepared[0]) {
            answer = await this.ask('measure prepare');
            this.progress(answer, 'errors');
        }
    }

    // How much of all is done, and how long the rest takes, by what is done since the start.
    progress({ progress: [done, all] }, words) {
        this.doneBefore ??= done;
        const left = this.seconds * (all - done) / (done - this.doneBefore);
        this.bar.value = done / all;
        this.status.value = `measuring ${words}${Number.isFinite(left) ? `: ${Math.ceil(left)} s left` : ''}`;
    }

    // What makes the times less sure.
    doubts() {
        const clock = `This browser’s clock has steps of ${live.digits(this.tick)} ms`;
        return [
            this.rounds < 6 && `After ${live.count(this.rounds, 'round')}: an interval of 95 % takes six.`,
            this.isTooShort ? `${clock}, too coarse for the shortest runs.`
                : this.tick >= 1 && `${clock}: each run is repeated for ${live.digits(this.least)} ms.`,
        ].filter(Boolean);
    }
};
