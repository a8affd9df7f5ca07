// Folds the sections behind the lesson: numbers for tests, and changes. A link into a fold opens it.
const folds = ['numbers-to-test-your-own-code-with', 'what-changed-since-the-last-stage'];

// The printed book shows all sections.
for (const id of location.pathname.endsWith('print.html') ? [] : folds) {
    const heading = document.querySelector(`main > h2#${id}`);
    if (!heading) {
        continue;
    }
    const details = document.createElement('details');
    const summary = document.createElement('summary');
    details.className = 'fold';
    const section = [];
    for (let next = heading.nextElementSibling; next && !next.matches('h1, h2'); next = next.nextElementSibling) {
        section.push(next);
    }
    // The heading is a link to itself; within the summary, which a click opens, it is none.
    heading.querySelector('a.header')?.replaceWith(heading.textContent);
    heading.before(details);
    summary.append(heading);
    details.append(summary, ...section);
}

// The printed book shows the lessons' code, too, and so does a page that is printed.
const openAll = () => document.querySelectorAll('main details').forEach((details) => (details.open = true));
if (location.pathname.endsWith('print.html')) {
    openAll();
}
addEventListener('beforeprint', openAll);

const openTarget = () => {
    // A link of the editor has a scene behind the #.
    if (!/^#(?!scene=)./.test(location.hash)) {
        return;
    }
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    let fold = target?.closest('details');
    if (!fold) {
        return;
    }
    // A fold may lie in another one.
    for (; fold; fold = fold.parentElement.closest('details')) {
        fold.open = true;
    }
    target.scrollIntoView();
};
addEventListener('hashchange', openTarget);
openTarget();

// On a phone a wide table folds, by the style sheet; its cells then need their heads.
for (const table of document.querySelectorAll('main table')) {
    const heads = [...table.querySelectorAll('th')].map((head) => {
        const copy = head.cloneNode(true);
        // A formula stands there twice: for the eye, and for screen readers.
        copy.querySelectorAll('.katex-mathml').forEach((formula) => formula.remove());
        return copy.textContent;
    });
    for (const row of table.tBodies[0]?.rows ?? []) {
        [...row.cells].forEach((cell, column) => (cell.dataset.head = heads[column] ?? ''));
    }
}

// A path or a command breaks at its spaces, and behind a hyphen only where it is longer than a line.
for (const code of document.querySelectorAll('main :not(pre) > code')) {
    if (!code.textContent.includes('-')) {
        continue;
    }
    const parts = code.textContent.split(/(\s+)/).map((word) => {
        const part = document.createElement('span');
        part.textContent = word;
        return word.includes('-') ? part : word;
    });
    code.replaceChildren(...parts);
}
