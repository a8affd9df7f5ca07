// Words of the text point: the name of something in a listing of the same section marks its
// lines there, and the parts of figures that have it as a class, `part-NAME`.
live.words = [];
{
    // The lines of a listing that have a name, as ranges.
    const lines = (listing, name) => {
        const places = [];
        for (const texts = document.createTreeWalker(listing, NodeFilter.SHOW_TEXT); texts.nextNode(); ) {
            const { currentNode } = texts;
            places.push(...Array.from({ length: currentNode.length }, (_, i) => [currentNode, i]));
        }
        let end = -1;
        return listing.textContent.split('\n').flatMap((line) => {
            const start = end + 1;
            end = start + line.length;
            const range = document.createRange();
            range.setStart(...(places[start] ?? [listing, 0]));
            range.setEnd(...(places[end] ?? [listing, 0]));
            return name.test(line) ? [range] : [];
        });
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
