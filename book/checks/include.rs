//! Listings: every include of a page shows something, and every anchor is included.
//! mdBook renders an empty listing without a warning.

use std::collections::HashSet;

use crate::Files;
use crate::files::{complaint, ending, resolve};

/// The includes that show nothing, and the anchors that no page includes.
#[must_use]
pub fn complaints(files: &Files) -> Vec<String> {
    let mut complaints = Vec::new();
    let mut included = HashSet::new();
    for (page, text) in files.pages() {
        for (at, target) in directives(text) {
            let (path, anchor) = target.split_once(':').unwrap_or((target, ""));
            let path = resolve(page, path).unwrap_or_default();
            // `book/build` makes the lists of the files of a stage.
            if path.starts_with("book/generated/") {
                continue;
            }
            let shown = files.text(&path).map(|text| shown(text, anchor));
            let wrong = shown.unwrap_or_else(|| Err("there is no such file".to_owned()));
            let wrong = wrong.map_err(|why| complaint(page, text, at, &format!("{target}: {why}")));
            complaints.extend(wrong.err());
            included.insert((path, anchor.to_owned()));
        }
    }
    // The files of this folder contain the words without being anchors.
    let sources = files.below("").filter(|(path, _)| ending(path) == "rs");
    for (path, text) in sources.filter(|(path, _)| !path.starts_with("book/")) {
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
fn shown(text: &str, anchor: &str) -> Result<(), String> {
    if anchor.starts_with(|c: char| c.is_ascii_digit() || c == ':') {
        return Err("name an anchor; line numbers change".to_owned());
    }
    let marks = |which: &'static str| {
        let marks = text.match_indices(which);
        let ends = marks.map(move |(at, _)| at + which.len());
        ends.filter(|end| name(&text[*end..]) == anchor)
    };
    let body = if anchor.is_empty() {
        text
    } else {
        let (open, close): (Vec<_>, Vec<_>) = (marks(OPEN).collect(), marks(CLOSE).collect());
        match (&open[..], &close[..]) {
            ([], _) => return Err("there is no such anchor".to_owned()),
            ([open], [close]) if open < close => &text[*open..*close],
            _ => return Err("the anchor is not opened and then closed once".to_owned()),
        }
    };
    let mut lines = body.lines().skip(usize::from(!anchor.is_empty()));
    let has_code = lines.any(|line| !line.trim().is_empty() && !line.contains("ANCHOR"));
    let empty = || "there is nothing to show".to_owned();
    has_code.then_some(()).ok_or_else(empty)
}

/// The name behind a mark.
fn name(behind: &str) -> &str {
    let behind = behind.trim_start_matches(' ');
    let end = behind.find(|c: char| !c.is_alphanumeric() && c != '_' && c != '-');
    &behind[..end.unwrap_or(behind.len())]
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: &str = "# A\n\n```rust,ignore\n{{#include ../../a/src/b.rs:c-1}}\n```\n";

    fn complaints_about(page: &str, source: &str) -> Vec<String> {
        complaints(&Files::of([
            ("book/src/a.md", page),
            ("a/src/b.rs", source),
        ]))
    }

    #[test]
    fn listings_that_show_nothing_are_found() {
        let (open, close) = ("// ANCHOR: c-1\n", "// ANCHOR_END: c-1\n");
        let none = "there is no such anchor";
        let twice = "the anchor is not opened and then closed once";
        let empty = "there is nothing to show";
        for (source, expected) in [
            (format!("a\n    {open}\nb\n  {close}"), None),
            ("b".to_owned(), Some(none)),
            (
                "// ANCHOR: c-12\nb\n// ANCHOR_END: c-12".to_owned(),
                Some(none),
            ),
            (format!("{open}b"), Some(twice)),
            (format!("{close}b\n{open}"), Some(twice)),
            (format!("{open}{open}b\n{close}"), Some(twice)),
            (format!("{open}b\n{close}{close}"), Some(twice)),
            (format!("{open}\n{close}b"), Some(empty)),
            (format!("{open}// ANCHOR: e\n{close}b"), Some(empty)),
        ] {
            let found = complaints_about(PAGE, &source);
            let start = "book/src/a.md:4: ../../a/src/b.rs:c-1: ";
            let found = found.first().and_then(|first| first.strip_prefix(start));
            assert_eq!(found, expected, "{source}");
        }
        for (target, expected) in [
            ("c.rs:c", "there is no such file"),
            ("b.rs", empty),
            ("b.rs:2:3", "name an anchor; line numbers change"),
        ] {
            let target = format!("../../a/src/{target}");
            let page = format!("{{{{#rustdoc_include {target}}}}}");
            let expected = format!("book/src/a.md:1: {target}: {expected}");
            assert_eq!(complaints_about(&page, "\n"), [expected]);
        }
    }

    #[test]
    fn an_anchor_that_no_page_includes_is_found() {
        let source = "\n// ANCHOR: d\nbody();\n// ANCHOR_END: d\n";
        let expected = ["a/src/b.rs:2: no page includes the anchor d"];
        assert_eq!(complaints_about("# A", source), expected);
        let escaped = r"\{{#include ../../a/src/b.rs:d}} {{#title A}}";
        assert_eq!(complaints_about(escaped, source), expected);
    }
}
