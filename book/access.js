// What readers with a keyboard or a screen reader need beyond mdBook's own pages.

// Past the menus at once.
const skip = document.createElement('a');
skip.className = 'skip-link';
skip.textContent = 'Skip to the text';
skip.href = '#text';
document.querySelector('main').id = 'text';
document.querySelector('main').tabIndex = -1;
document.body.prepend(skip);

// The label that opens the table of contents acts as a button.
const toggle = document.getElementById('mdbook-sidebar-toggle');
toggle?.setAttribute('role', 'button');
toggle?.setAttribute('tabindex', '0');
toggle?.addEventListener('keydown', (event) => {
    if (event.key === 'Enter' || event.key === ' ') {
        event.preventDefault();
        toggle.click();
    }
});
document.getElementById('mdbook-menu-bar')?.setAttribute('role', 'banner');

// What scrolls by itself is reached by the Tab key, as long as it scrolls.
const scrolling = document.querySelectorAll('main :is(pre > code, .katex-display, .table-wrapper)');
const sizes = new ResizeObserver((entries) => {
    for (const { target } of entries) {
        const scrolls = target.scrollWidth > target.clientWidth + 1;
        scrolls ? target.setAttribute('tabindex', '0') : target.removeAttribute('tabindex');
    }
});
scrolling.forEach((element) => sizes.observe(element));

// A page that would be live says why it is not: the book was built without the module, or the
// browser cannot run it.
const isBuilt = typeof live !== 'undefined';
const isLivePage = document.querySelector('main img:is([src*="pictures/a0"], [src*="diagrams/"])');
if ((isLivePage || location.pathname.includes('scene-editor')) && !(isBuilt && live.works)) {
    const note = document.createElement('p');
    note.className = 'not-live';
    note.textContent = isBuilt
        ? 'The pictures and figures of this page are not live: this browser does not run WebAssembly, or forbids it.'
        : 'The pictures and figures of this page are not live: the book was built without the target wasm32-unknown-unknown, which rustup adds.';
    document.querySelector('main h1').after(note);
}
