//! The way of a ray in CONTRIBUTING.md: each function calls the one of the next row.

use crate::files::Files;

const GUIDE: &str = "CONTRIBUTING.md";

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
    let rows = table.unwrap_or_default().lines().skip(2);
    let mut steps = Vec::new();
    for row in rows {
        let mut cells = row.split('|').skip(1);
        let [file, functions] = [cells.next(), cells.next()].map(Option::unwrap_or_default);
        let file = quoted(file).next().unwrap_or_default();
        let functions = functions.split(':').next().unwrap_or_default();
        steps.extend(quoted(functions).map(|function| (file, function)));
    }
    assert!(steps.len() > 1, "{GUIDE} has no way of a ray");
    let mut complaints = Vec::new();
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
