//! Listings: every include of a page shows something, and every anchor is included.
//! mdBook renders an empty listing without a warning.

use std::collections::HashSet;

use crate::files::{Files, complaint, resolve};

/// The includes that show nothing, and the anchors that no page includes.
pub fn complaints(files: &Files) -> Vec<String> {
    let mut complaints = Vec::new();
    let mut included = HashSet::new();
    for (page, text) in files.pages() {
        for (at, target) in directives(text) {
            let (path, anchor) = target.split_once(':').unwrap_or((target, ""));
            let path = resolve(page, path).unwrap_or_default();
            // `cargo book` makes the lists of the files of a stage.
            if path.starts_with("book/generated/") {
                continue;
            }
            let shown = files.text(&path).map(|text| shown(text, anchor));
            if let Err(why) = shown.unwrap_or(Err("there is no such file")) {
                complaints.push(complaint(page, text, at, &format!("{target}: {why}")));
            }
            included.insert((path, anchor.to_owned()));
        }
    }
    // The files of this folder contain the words without being anchors.
    for (path, text) in files.rust().filter(|(path, _)| !path.starts_with("book/")) {
        for (at, _) in text.match_indices(OPEN) {
            let name = name(&text[at + OPEN.len()..]);
            if !included.contains(&(path.to_owned(), name.to_owned())) {
                let wrong = format!("no page includes the anchor {name}");
                complaints.push(complaint(path, text, at, &wrong));
            }
        }
    }
    complaints
}

const OPEN: &str = "ANCHOR:";
const CLOSE: &str = "ANCHOR_END:";

/// The includes of a text: their places and their arguments.
pub fn directives(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let starts = text.match_indices("{{#");
    starts.filter_map(|(at, start)| {
        let (inner, _) = text[at + start.len()..].split_once("}}")?;
        let (kind, target) = inner.split_once(char::is_whitespace)?;
        let is_escaped = text[..at].ends_with('\\');
        (kind.ends_with("include") && !is_escaped).then_some((at, target.trim()))
    })
}

/// An error if the anchor of a file, or without a name the whole file, has nothing to
/// show.
fn shown(text: &str, anchor: &str) -> Result<(), &'static str> {
    let lines: Vec<_> = text.lines().collect();
    let marks = |mark| {
        let is_mark = |line: &str| {
            let behind = line.split_once(mark);
            behind.is_some_and(|(_, behind)| name(behind) == anchor)
        };
        let all = (0..lines.len()).filter(|number| is_mark(lines[*number]));
        all.collect::<Vec<_>>()
    };
    let body = match (&marks(OPEN)[..], &marks(CLOSE)[..]) {
        _ if anchor.is_empty() => &lines[..],
        _ if anchor.starts_with(|c: char| c.is_ascii_digit() || c == ':') => {
            return Err("name an anchor; line numbers change");
        }
        ([], _) => return Err("there is no such anchor"),
        ([open], [close]) if open < close => &lines[*open..*close],
        _ => return Err("the anchor is not opened and then closed once"),
    };
    let mut code = body.iter().filter(|line| !line.trim().is_empty());
    if code.all(|line| line.contains("ANCHOR")) {
        return Err("there is nothing to show");
    }
    Ok(())
}

/// The name behind a mark.
fn name(behind: &str) -> &str {
    let behind = behind.trim_start_matches(' ');
    let end = behind.find(|c: char| !c.is_alphanumeric() && c != '_' && c != '-');
    &behind[..end.unwrap_or(behind.len())]
}
