// Words of the text point: the name of something in a listing of the same section marks its
// lines there, and the parts of figures that have it as a class, `part-NAME`.
live.words = [];
{
    // The lines of a listing that have a name, as ranges.
    const lines = (listing, name) => {
        const nodes = document.createTreeWalker(listing, NodeFilter.SHOW_TEXT);
        const ranges = [];
        let start = 0;
        for (const line of listing.textContent.split('\n')) {
            const end = start + line.length;
            if (name.test(line)) {
                ranges.push([start, end]);
            }
            start = end + 1;
        }
        const found = ranges.map(() => document.createRange());
        let before = 0;
        while (nodes.nextNode()) {
            const { length } = nodes.currentNode;
            ranges.forEach(([from, to], i) => {
                if (from >= before && from < before + length) {
                    found[i].setStart(nodes.currentNode, from - before);
                }
                if (to > before && to <= before + length) {
                    found[i].setEnd(nodes.currentNode, to - before);
                }
            });
            before += length;
        }
        return found;
    };

    const rule = document.head.appendChild(live.element('style'));
    const point = (word, listings, name) => {
        const ranges = listings.flatMap((listing) => lines(listing, name));
        CSS.highlights.set('live-pointed', new Highlight(...ranges));
        // A rule outlives the next drawing of a figure, which has new shapes.
        const part = CSS.escape(word.textContent.split('.').pop());
        rule.textContent = `.live-figure svg .part-${part} { stroke-width: 6; stroke-dasharray: none; font-weight: 800 }`;
    };
    const end = () => {
        CSS.highlights.delete('live-pointed');
        rule.textContent = '';
    };

    const sections = [[]];
    for (const element of globalThis.Highlight ? document.querySelectorAll('main > *') : []) {
        if (element.matches('h2')) {
            sections.push([]);
        }
        sections.at(-1).push(element);
    }
    for (const section of sections) {
        const listings = section.flatMap((element) => [...element.querySelectorAll('code.ignore')]);
        const words = section.flatMap((element) => [...element.querySelectorAll(':not(pre, a) > code')]);
        for (const word of words) {
            const name = new RegExp(`(?<![\\w.])${word.textContent.replace(/\W/g, '\\$&')}(?!\\w)`);
            if (listings.some((listing) => name.test(listing.textContent))) {
                const show = () => point(word, listings, name);
                Object.assign(word, { tabIndex: 0, onfocus: show, onpointerenter: show, onblur: end, onpointerleave: end });
                word.classList.add('live-word');
                live.words.push(word);
            }
        }
    }
}
