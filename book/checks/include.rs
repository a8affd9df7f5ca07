//! Listings: every include of a page exists, and every anchor is included.

use std::collections::HashSet;

use crate::Files;
use crate::files::{ending, resolve};
use crate::page::complaint;

/// The includes that show nothing, and the marks that no page asks for.
#[must_use]
pub fn complaints(files: &Files) -> Vec<String> {
    let mut complaints = Vec::new();
    let mut included = HashSet::new();
    for page in files.pages() {
        for (at, target) in directives(page.text) {
            let (path, anchor) = target.split_once(':').unwrap_or((target, ""));
            let path = resolve(page.path, path).unwrap_or_default();
            let wrong = match files.text(&path) {
                None => Err(format!("{target} does not exist")),
                Some(text) => check(text, anchor).map_err(|why| format!("{path}: {why}")),
            };
            let wrong = wrong.err();
            complaints.extend(wrong.map(|wrong| page.complain(at, &wrong)));
            included.insert((path, anchor.to_owned()));
        }
    }
    // This crate speaks of marks without having one.
    let sources = files.below("").filter(|(path, _)| ending(path) == "rs");
    for (path, text) in sources.filter(|(path, _)| !path.starts_with("book/")) {
        for (index, line) in text.lines().enumerate() {
            let Some(name) = mark(line, OPEN).or_else(|| mark(line, CLOSE)) else {
                continue;
            };
            if !included.contains(&(path.to_owned(), name.to_owned())) {
                let wrong = format!("no page includes the anchor {name}");
                complaints.push(complaint(path, index + 1, &wrong));
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
        let escaped = text[..at].ends_with('\\');
        (kind.ends_with("include") && !escaped).then_some((at, target.trim()))
    })
}

/// Whether the anchor of a file, or with no name the file, has something to show.
fn check(text: &str, anchor: &str) -> Result<(), String> {
    if anchor.is_empty() {
        let empty = text.trim().is_empty();
        return if empty {
            Err("it is empty".into())
        } else {
            Ok(())
        };
    }
    if anchor.starts_with(|c: char| c.is_ascii_digit() || c == ':') {
        return Err(format!(
            "name an anchor; lines {anchor} will be others soon"
        ));
    }
    let places = |which| {
        let lines = text.lines().enumerate();
        let of_name = lines.filter(move |(_, line)| mark(line, which) == Some(anchor));
        of_name.map(|(index, _)| index).collect::<Vec<_>>()
    };
    match (&places(OPEN)[..], &places(CLOSE)[..]) {
        ([], _) => Err(format!("there is no anchor {anchor}")),
        ([_, _, ..], _) => Err(format!("the anchor {anchor} is opened more than once")),
        (_, []) => Err(format!("the anchor {anchor} is never closed")),
        (_, [_, _, ..]) => Err(format!("the anchor {anchor} is closed more than once")),
        ([open], [close]) if close < open => {
            Err(format!("the anchor {anchor} is closed before it is opened"))
        }
        ([open], [close]) => {
            let mut body = text.lines().take(*close).skip(open + 1);
            let shown = |line: &str| !line.trim().is_empty() && !line.contains("ANCHOR");
            let found = body.any(shown);
            found
                .then_some(())
                .ok_or(format!("the anchor {anchor} is empty"))
        }
    }
}

/// The name that a line opens or closes.
fn mark<'a>(line: &'a str, which: &str) -> Option<&'a str> {
    let (_, name) = line.split_once(which)?;
    let name = name.trim_start();
    let end = name.find(|c: char| !c.is_alphanumeric() && c != '_' && c != '-');
    Some(&name[..end.unwrap_or(name.len())])
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: &str = "# A\n\n```rust,ignore\n{{#include ../../a/src/b.rs:c}}\n```\n";

    fn complaints_about(page: &str, source: &str) -> Vec<String> {
        complaints(&Files::of([
            ("book/src/a.md", page),
            ("a/src/b.rs", source),
        ]))
    }

    #[test]
    fn an_anchor_with_a_body_is_right() {
        let source = "    // ANCHOR: c\n    body();\n    // ANCHOR_END: c\n";
        assert_eq!(complaints_about(PAGE, source), [""; 0]);
    }

    #[test]
    fn what_shows_nothing_is_found() {
        let cases = [
            ("body();", "there is no anchor c"),
            ("// ANCHOR: cc\n// ANCHOR_END: cc", "there is no anchor c"),
            ("// ANCHOR: c\nbody();", "the anchor c is never closed"),
            ("// ANCHOR: c\n\n// ANCHOR_END: c", "the anchor c is empty"),
            (
                "// ANCHOR_END: c\nbody();\n// ANCHOR: c",
                "the anchor c is closed before it is opened",
            ),
            (
                "// ANCHOR: c\na();\n// ANCHOR_END: c\n// ANCHOR: c\nb();",
                "the anchor c is opened more than once",
            ),
            (
                "// ANCHOR: c\na();\n// ANCHOR_END: c\n// ANCHOR_END: c",
                "the anchor c is closed more than once",
            ),
        ];
        for (source, why) in cases {
            let expected = format!("book/src/a.md:4: a/src/b.rs: {why}");
            assert_eq!(complaints_about(PAGE, source)[0], expected);
        }
    }

    #[test]
    fn a_missing_file_is_found() {
        assert_eq!(
            complaints_about("{{#include ../../a/src/c.rs:c}}", ""),
            ["book/src/a.md:1: ../../a/src/c.rs:c does not exist"]
        );
    }

    #[test]
    fn an_empty_file_and_counted_lines_are_found() {
        assert_eq!(
            complaints_about("{{#include ../../a/src/b.rs}}", "\n"),
            ["book/src/a.md:1: a/src/b.rs: it is empty"]
        );
        assert_eq!(
            complaints_about("{{#rustdoc_include ../../a/src/b.rs:2:3}}", "a\nb\nc\n"),
            ["book/src/a.md:1: a/src/b.rs: name an anchor; lines 2:3 will be others soon"]
        );
    }

    #[test]
    fn an_anchor_that_no_page_includes_is_found() {
        let source = "\n// ANCHOR: c\nbody();\n// ANCHOR_END: c\n";
        assert_eq!(
            complaints_about("# A", source),
            [
                "a/src/b.rs:2: no page includes the anchor c",
                "a/src/b.rs:4: no page includes the anchor c"
            ]
        );
    }

    #[test]
    fn what_is_escaped_is_no_include() {
        assert_eq!(directives(r"\{{#include a.rs}} {{#title A}}").count(), 0);
    }

    /// The first line of an anchor may be empty, and the last one may not; the
    /// text around it is not shown.
    #[test]
    fn an_anchor_shows_what_lies_between_its_marks() {
        let shown = |source: &str| check(source, "c_d-1").is_ok();
        let marked = |body| {
            let source = format!("a();\n\n// ANCHOR: c_d-1\n{body}// ANCHOR_END: c_d-1\nb();\n");
            shown(&source)
        };
        assert!(marked("\nbody();\n") && marked("body();\n\n"));
        assert!(!marked("") && !marked("\n") && !marked("// ANCHOR: e\n"));
        assert!(!shown("// ANCHOR: c_d-1 ANCHOR_END: c_d-1\nb();"));
    }
}
