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

    progress(done, all, words) {
        this.bar.value = done / all;
        this.status.value = `${words}: ${Math.ceil(this.seconds * (all / done - 1))} s left`;
    }
};
