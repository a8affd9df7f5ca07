// The extreme cases of a stage as the program prints them, computed on the page.
live.Cases = class {
    constructor(place) {
        const stages = [...new Set(Object.keys(live.locks).map((name) => /^a0[2-7]-(math|rays-cameras|intersections|lighting|shadows-reflection|transforms)/.exec(name)?.[0]).filter(Boolean))];
        this.stage = live.element('select', { 'aria-label': 'stage' }, ...stages.map((name) => live.element('option', {}, name)));
        this.filter = live.element('input', { type: 'search', size: 12, 'aria-label': 'show only cases with this number or text', oninput: () => this.show() });
        this.status = live.element('output');
        const compute = live.button('compute', () => this.run().catch(live.complain(this.status)));
        const stop = live.button('stop', () => live.stop('stopped'));
        this.rows = live.element('pre', { className: 'live-rows', tabIndex: 0 });
        this.cases = [];
        this.root = live.element('details', {}, live.element('summary', {}, 'The program’s cases, by number'),
            live.element('div', { className: 'live-controls' }, this.stage, ' ', compute, ' ', stop, ' only: ', this.filter, ' ', this.status),
            this.rows);
        place.append(this.root);
    }

    async run() {
        this.status.value = 'computing …';
        const start = performance.now();
        const { text, cases, held } = await live.ask(`extremes ${this.stage.value}`);
        const time = (performance.now() - start).toFixed(0);
        this.status.value = `${held[0]} of ${cases[0]} cases hold; ${time} ms`;
        this.cases = text.split('\n\n');
        this.show();
    }

    show() {
        const wanted = this.filter.value.toLowerCase().split(/[ ,]+/).filter(Boolean);
        const isWanted = (row) => !wanted.length || wanted.some((word) => row.toLowerCase().includes(word));
        this.rows.textContent = this.cases.filter(isWanted).join('\n\n');
    }
};
