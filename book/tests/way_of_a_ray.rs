//! The way of a ray in CONTRIBUTING.md: each function calls the one of the next row, and the way
//! is short.

use crate::files::Files;

const GUIDE: &str = "CONTRIBUTING.md";

/// Most files from `main` to the loop over the pixels.
const MOST_FILES: usize = 8;

/// Missing files, functions and calls on the way.
pub fn complaints(files: &Files) -> Vec<String> {
    let guide = files.text(GUIDE).unwrap_or_default();
    let section = guide
        .split("## The way of a ray")
        .nth(1)
        .unwrap_or_default();
    let table = section
        .split("\n\n")
        .find(|part| part.starts_with("| file"));
    // Below the head and the line under it.
    let rows: Vec<_> = table.unwrap_or_default().lines().skip(2).collect();
    let mut complaints = Vec::new();
    let mut steps = Vec::new();
    for row in &rows {
        let mut cells = row.split('|').skip(1);
        let [file, functions] = [cells.next(), cells.next()].map(Option::unwrap_or_default);
        let file = quoted(file).next().unwrap_or_default();
        let functions = functions.split(':').next().unwrap_or_default();
        steps.extend(quoted(functions).map(|function| (file, function)));
    }
    if !(2..=MOST_FILES).contains(&rows.len()) {
        complaints.push(format!(
            "{GUIDE}: the way of a ray has {} files",
            rows.len()
        ));
    }
    for step in steps.windows(2) {
        let [(file, function), (_, next)] = [step[0], step[1]];
        let text = files.text(file).unwrap_or_default();
        let call = format!("{next}(");
        if !bodies(text, function).any(|body| body.contains(&call)) {
            complaints.push(format!(
                "{GUIDE}: {function} of {file} does not call {next}"
            ));
        }
    }
    if let Some((file, function)) = steps.last() {
        let text = files.text(file).unwrap_or_default();
        if !bodies(text, function).any(|body| body.contains("for (column, pixel) in")) {
            complaints.push(format!(
                "{GUIDE}: {function} of {file} has no loop over the pixels"
            ));
        }
    }
    complaints
}

/// The parts of a text between backquotes.
fn quoted(text: &str) -> impl Iterator<Item = &str> {
    text.split('`').skip(1).step_by(2)
}

/// The bodies of the functions of a name, which end at a brace as far indented as they are.
fn bodies<'a>(text: &'a str, function: &str) -> impl Iterator<Item = &'a str> {
    let head = format!("fn {function}(");
    let starts = text.match_indices(&head).collect::<Vec<_>>().into_iter();
    starts.map(move |(at, head)| {
        let line = text[..at].rfind('\n').map_or(0, |end| end + 1);
        let indent = text[line..].chars().take_while(|c| *c == ' ').count();
        let after = &text[at + head.len()..];
        let end = after.find(&format!("\n{}}}", " ".repeat(indent)));
        &after[..end.unwrap_or(after.len())]
    })
}
