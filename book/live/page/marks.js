// Marks lines and numbers of a text area: a copy of its text lies behind it, and its marks shine
// through.
live.Marks = class {
    constructor(text) {
        this.text = text;
        this.lines = live.element('div');
        this.element = live.element('div', { className: 'live-marks', ariaHidden: 'true' }, this.lines);
        text.addEventListener('scroll', () => this.place());
    }

    // Marks ranges of the text, each `{ start, end, strength }` with a strength from 0 to 1.
    show(ranges) {
        const sorted = ranges.toSorted((a, b) => a.start - b.start);
        let start = 0;
        const lines = sorted.length === 0 ? [] : this.text.value.split('\n').map((words) => {
            const end = start + words.length;
            const line = this.line(words, start, sorted.filter((range) => range.start >= start && range.start <= end));
            start = end + 1;
            return line;
        });
        this.lines.replaceChildren(...lines);
        this.place();
    }

    // A line of the text, which begins at a place, with the ranges in it.
    line(words, start, ranges) {
        const line = live.element('div');
        let done = 0;
        for (const range of ranges) {
            const [from, to] = [range.start - start, range.end - start];
            // The channels of a colour by its name are in one place.
            if (from >= done) {
                line.append(words.slice(done, from), live.element('mark', {}, words.slice(from, to)));
                done = to;
            }
        }
        line.append(words.slice(done));
        if (ranges.length > 0) {
            line.className = 'live-line';
            line.style.setProperty('--strength', Math.max(...ranges.map(({ strength }) => strength)));
        }
        return line;
    }

    // Scrolls with the text.
    place() {
        const { scrollLeft, scrollTop } = this.text;
        this.lines.style.translate = `${-scrollLeft}px ${-scrollTop}px`;
    }
};
