// A scene file to write on the page: the text beside its picture, each mistake below its line, and
// the whole text in the link. A line shows its pixels, and a pixel its lines.
live.Editor = class {
    constructor(listing, image) {
        this.text = live.element('textarea', { value: listing.textContent, spellcheck: false, 'aria-label': 'scene file' });
        this.mistake = live.element('output', { className: 'live-mistake' });
        this.marks = new live.Marks(this.text);
        this.said = live.element('output', { className: 'live-said' });
        this.measured = live.element('a', {}, 'how many samples does it need?');
        this.light = live.element('input', { type: 'checkbox', checked: true });
        this.picture = new live.Picture(image);
        this.numbers = new live.SceneNumbers(this);
        this.dependents = new live.Dependents(this);
        this.influences = new live.Influences(this);
        this.light.onchange = () => this.dependents.hide();
        const controls = live.div('live-controls',
            live.element('label', {}, this.light, ' light up the pixels of the cursor’s line'),
            live.button('which number makes a pixel?', () => this.ask()), ' ', this.measured);
        const written = live.div('live-text', this.marks.element, this.text, this.mistake);
        const [pre, paragraph] = [listing.closest('pre'), image.closest('p')];
        const left = live.div('', written, this.said, controls, pre.nextElementSibling);
        const right = live.div('', paragraph, live.caption(image));
        this.omitted = live.element('a', {}, 'what does it leave out?');
        controls.append(' ', this.omitted);
        pre.replaceWith(live.div('live-editor', left, right));
        // A click on a pixel, or Enter in the picture, asks for its numbers.
        this.picture.tapped = (...pixel) => this.influences.open(...pixel);
        live.keys(this.picture.frame, { Enter: () => this.ask() });
        this.update = live.newest(() => this.draw(), ({ message }) => this.complain(message));
        this.text.oninput = () => {
            clearTimeout(this.pause);
            this.pause = setTimeout(() => this.change(), 250);
        };
        this.text.onscroll = () => this.place();
        addEventListener('hashchange', () => this.open());
        this.open();
    }

    // The scene of the link, if it has one.
    open() {
        const [, scene] = /^#scene=(.*)/.exec(location.hash) ?? [];
        if (scene) {
            try {
                this.text.value = decodeURIComponent(scene);
            } catch {
                return this.complain('the scene in this link is cut off or damaged');
            }
        }
        return this.change();
    }

    // Draws the text, even if an older one takes long.
    async change() {
        clearTimeout(this.picture.pause);
        this.picture.update?.forget();
        await live.stop('stopped: the text has changed');
        this.influences.close();
        await this.update();
    }

    async draw() {
        const { picture } = this;
        const { value } = this.text;
        const name = `file\n${value}`;
        picture.about = await live.ask(`about ${name}`);
        picture.name = name;
        this.complain('');
        this.drawn = value;
        history.replaceState(null, '', `#scene=${encodeURIComponent(value)}`);
        this.measured.href = `error-and-run-time.html${location.hash}`;
        this.omitted.href = `left-out.html${location.hash}`;
        await picture.begin();
        if (picture.begun) {
            const { yaw, pitch, zoom } = picture.settings;
            const { shrunk } = picture;
            picture.reset();
            picture.shrunk = shrunk;
            await picture.change({ yaw, pitch, zoom });
            this.dependents.prepare();
        }
    }

    // Draws a text in which a slider has changed a number; then the rows say what it does now.
    async slide() {
        clearTimeout(this.picture.pause);
        await live.stop('stopped: a number has changed');
        await this.update();
        clearTimeout(this.pause);
        this.pause = setTimeout(() => this.influences.update(false), 250);
    }

    // The numbers behind the last pixel, or the one in the middle.
    ask() {
        const { width, height } = this.picture.settings ?? {};
        if (width) {
            this.influences.open(...(this.influences.pixel ?? [width / 2, height / 2]));
            this.influences.places[0].focus();
        }
    }

    // Puts the cursor on a number.
    select({ line, start, end }) {
        this.text.focus();
        this.text.setSelectionRange(start, end);
        this.reveal(line);
    }

    get lineHeight() {
        return parseFloat(getComputedStyle(this.text).lineHeight);
    }

    // Scrolls to a line that is not seen.
    reveal(line) {
        const { text, lineHeight } = this;
        const top = (line - 1) * lineHeight;
        if (top < text.scrollTop || top + 2 * lineHeight > text.scrollTop + text.clientHeight) {
            text.scrollTop = top - text.clientHeight / 3;
        }
    }

    // Shows a mistake, which begins with its line and column. What was said of an earlier text ends.
    complain(message) {
        if (message) {
            this.said.value = '';
            this.dependents.hide();
            this.picture.status && (this.picture.status.value = '');
        }
        const [, line, words] = /^(\d+):\d+: (.*)/s.exec(message) ?? [];
        this.line = Number(line ?? 0);
        this.mistake.value = line ? `line ${line}: ${words}` : message;
        this.place();
    }

    // Below the line of the mistake, or at the edge nearest to it.
    place() {
        const { text, mistake } = this;
        const below = this.line * this.lineHeight + 5 - text.scrollTop;
        mistake.style.top = `${Math.min(Math.max(below, 0), text.clientHeight - mistake.offsetHeight)}px`;
    }
};

live.editor = live.tool('what-the-page-draws', () =>
    new live.Editor(document.querySelector('main code.language-toml'), document.querySelector('main img[src$="scene-shapes.png"]')));
