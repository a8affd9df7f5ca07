// A picture by the reader's code, beside the lesson's. `cargo learn book` builds a module of
// the solved exercises of each stage, and names them in `live.yours`.
live.Yours = class {
    // One for each exercise of the stage, in a worker of its own: it may never end.
    static of(picture) {
        const stages = Object.entries(live.yours ?? {});
        const [stage, names] = stages.find(([stage]) => picture.name.startsWith(`${stage}-`)) ?? ['', []];
        return names.map((name) => new live.Yours(picture, stage, name));
    }

    constructor(picture, stage, name) {
        Object.assign(this, { picture, stage, name });
        this.canvas = live.element('canvas', { className: 'live-canvas' });
        this.canvas.style.width = picture.canvas.style.width;
        this.status = live.element('output', { className: 'live-status' });
        this.frame = live.element('span', { className: 'live-yours' }, this.canvas, this.status);
        this.update = live.newest((lesson) => this.render(lesson), ({ message }) => {
            this.say(message === 'unreachable' ? 'panics' : `fails: ${message}`);
        });
    }

    // Renders with the settings of the lesson's picture, but by the scene's own camera.
    async render(lesson) {
        const { picture, name } = this;
        const { yaw, pitch, zoom } = picture.settings;
        this.started ??= live.start(`yours-${this.stage}.js`);
        const post = await this.started;
        const end = setTimeout(() => {
            this.started = undefined;
            post.stop('no end within 10 seconds');
        }, 10_000);
        try {
            const numbers = picture.numbers();
            const answer = await post({ request: `${name} ${picture.name}`, numbers });
            if (!answer.size) {
                // The exercise draws another scene.
                picture.yours = picture.yours?.filter((yours) => yours !== this);
                return post.stop();
            }
            live.paint(this.canvas, answer);
            const differs = lesson?.pixels.some((byte, i) => Math.abs(answer.pixels[i] - byte) > 1);
            const verdict = differs ? 'does NOT draw the same' : lesson ? 'draws the same' : 'draws this';
            this.say(yaw || pitch || zoom !== 1 ? 'draws it by the camera of the scene' : verdict);
        } finally {
            clearTimeout(end);
        }
    }

    say(verdict) {
        this.status.value = `Your ${this.name}.rs ${verdict}.`;
        if (!this.frame.isConnected) {
            this.picture.frame.after(this.frame);
        }
    }
};

// The pictures that no scene shows: the reader's code alone draws them.
for (const image of live.yours ? live.images('img[src*="-exercise-"]') : []) {
    const [, name, stage, exercise] = /(([^/]+)-exercise-([^/]+))\.png$/.exec(image.src);
    const file = exercise.replaceAll('-', '_');
    if (live.yours[stage]?.includes(file)) {
        const frame = image.closest('label') ?? image;
        const yours = new live.Yours({ name, frame, canvas: image, settings: { zoom: 1 }, numbers: () => [] }, stage, file);
        image.closest('p').append(' ', live.button(`draw it by your ${file}.rs`, () => yours.update()));
    }
}
