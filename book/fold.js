// Folds the sections behind the lesson: numbers for tests, mistakes of the protocol, cases
// that break, costs, and changes. A link into a fold opens it.
const folds = ['numbers-to-test-your-own-code-with', 'the-protocols-problem', 'what-can-go-wrong', 'what-it-costs', 'what-changed-since-the-last-stage'];

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
    // The heading is a link to itself.
    summary.onclick = (event) => {
        if (event.target.closest('a')) {
            event.preventDefault();
            details.open = !details.open;
        }
    };
    heading.before(details);
    summary.append(heading);
    details.append(summary, ...section);
}

const openTarget = () => {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    const fold = target?.closest('details.fold');
    if (fold) {
        fold.open = true;
        target.scrollIntoView();
    }
};
addEventListener('hashchange', openTarget);
openTarget();
