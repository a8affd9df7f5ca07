// The extreme cases of a stage as the program prints them, computed on the page.
live.Cases = class {
    constructor(place) {
        const stages = [...new Set(Object.keys(live.locks).map((name) => /^a0[2-7]-(math|rays-cameras|intersections|lighting|shadows-reflection|transforms)/.exec(name)?.[0]).filter(Boolean))];
        this.stage = live.select('stage', stages.map((name) => [name, name]));
        this.filter = live.element('input', { type: 'search', size: 12, 'aria-label': 'show only cases with this number or text', oninput: () => this.show() });
        this.run = new live.Run('compute', () => this.compute());
        this.rows = live.element('pre', { className: 'live-rows', tabIndex: 0 });
        this.cases = [];
        this.root = live.element('details', {}, live.element('summary', {}, 'The program’s cases, by number'),
            live.div('live-controls', this.stage, ' only: ', this.filter, ' ', ...this.run.controls),
            this.rows);
        place.append(this.root);
    }

    async compute() {
        const { text, cases, held } = await this.run.ask(`extremes ${this.stage.value}`);
        this.cases = text.split('\n\n');
        this.show();
        return `${held[0]} of ${cases[0]} cases hold; ${live.time(this.run.seconds)}`;
    }

    show() {
        const wanted = this.filter.value.toLowerCase().split(/[ ,]+/).filter(Boolean);
        const isWanted = (row) => !wanted.length || wanted.some((word) => row.toLowerCase().includes(word));
        this.rows.textContent = this.cases.filter(isWanted).join('\n\n');
    }
};
