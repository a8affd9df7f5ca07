// The extreme cases of a stage, computed on the page.
live.Extremes = class {
    constructor(before) {
        const stages = [...new Set(Object.keys(live.locks).map((name) => /^a0[2-7]-(math|rays-cameras|intersections|lighting|shadows-reflection|transforms)/.exec(name)?.[0]).filter(Boolean))];
        this.stage = live.element('select', { 'aria-label': 'stage' }, ...stages.map((name) => live.element('option', {}, name)));
        this.filter = live.element('input', { type: 'search', size: 12, 'aria-label': 'show only cases with this text', oninput: () => this.show() });
        this.status = live.element('output');
        const compute = live.button('compute', () => this.run().catch(live.complain(this.status)));
        this.rows = live.element('pre', { className: 'live-rows' });
        this.cases = [];
        before.before(live.panel('Ask the hard questions here', 'The same cases as the program’s, by the same code, with as many rays as its quick reports.',
            live.element('div', { className: 'live-controls' }, this.stage, ' ', compute, ' only: ', this.filter, ' ', this.status),
            this.rows));
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
        const wanted = this.filter.value.toLowerCase();
        this.rows.textContent = this.cases.filter((row) => row.toLowerCase().includes(wanted)).join('\n\n');
    }
};

live.extremes = live.tool('which-letter-is-where', (heading) => new live.Extremes(heading));
