// A scene file to write on the page: the text beside its picture, each mistake below its line, and
// the whole text in the link.
live.Editor = class {
    constructor(listing, image) {
        this.text = live.element('textarea', { value: listing.textContent, spellcheck: false, 'aria-label': 'scene file' });
        this.mistake = live.element('output', { className: 'live-mistake' });
        this.picture = new live.Picture(image);
        const [pre, paragraph] = [listing.closest('pre'), image.closest('p')];
        const left = live.element('div', {}, this.text, this.mistake, pre.nextElementSibling);
        const right = live.element('div', {}, paragraph, live.caption(image));
        pre.replaceWith(live.element('div', { className: 'live-editor' }, left, right));
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
        await this.update();
    }

    async draw() {
        const { picture } = this;
        const name = `file\n${this.text.value}`;
        picture.about = await live.ask(`about ${name}`);
        picture.name = name;
        this.complain('');
        history.replaceState(null, '', `#scene=${encodeURIComponent(this.text.value)}`);
        await picture.begin();
        if (picture.begun) {
            const { yaw, pitch, zoom } = picture.settings;
            picture.reset();
            await picture.change({ yaw, pitch, zoom });
        }
    }

    // Shows a mistake, which begins with its line and column.
    complain(message) {
        const [, line, words] = /^(\d+):\d+: (.*)/s.exec(message) ?? [];
        this.line = Number(line ?? 0);
        this.mistake.value = line ? `line ${line}: ${words}` : message;
        this.place();
    }

    // Below the line of the mistake, or at the edge nearest to it.
    place() {
        const { text, mistake } = this;
        const below = this.line * parseFloat(getComputedStyle(text).lineHeight) + 5 - text.scrollTop;
        mistake.style.top = `${Math.min(Math.max(below, 0), text.clientHeight - mistake.offsetHeight)}px`;
    }
};

live.editor = live.tool('what-the-page-draws', () =>
    new live.Editor(document.querySelector('main code.language-toml'), document.querySelector('main img[src$="scene-file.png"]')));
