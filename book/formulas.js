// Draws the formulas of the page, whose text is TeX. One that is wrong shows its text and the mistake.
for (const formula of document.querySelectorAll('.formula')) {
    katex.render(formula.textContent, formula, { displayMode: formula.matches('.display'), throwOnError: false });
}
