//! The page about extreme cases has the table that the results of the corpus give.

use super::files::{Files, complaint};

const PAGE: &str = "book/src/extreme-cases.md";

/// The rows that the page lacks.
pub fn complaints(files: &Files) -> Vec<String> {
    let page = files.text(PAGE).unwrap_or_default();
    let results = |name: &str| {
        let text = files.text(&format!("common/corpus/results/{name}.txt"));
        text.map(str::to_owned)
    };
    let table = match corpus::table(results) {
        Ok(table) => table,
        Err(problem) => return vec![problem.to_string()],
    };
    let mut complaints = Vec::new();
    for row in table.lines() {
        if !page.lines().any(|line| line == row) {
            complaints.push(complaint(PAGE, page, 0, &format!("lacks the row {row}")));
        }
    }
    complaints
}
