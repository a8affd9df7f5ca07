//! Every chapter is in the summary, once, and every one named there exists.

use std::collections::HashSet;

use pulldown_cmark::{Event, Tag};

use crate::Files;
use crate::files::{SUMMARY, resolve};
use crate::page::{Page, complaint};

/// The mistakes in the list of chapters.
#[must_use]
pub fn complaints(files: &Files) -> Vec<String> {
    let text = files.text(SUMMARY).unwrap_or_default();
    let summary = Page {
        path: SUMMARY,
        text,
    };
    let mut complaints = Vec::new();
    let mut named = HashSet::new();
    for (event, range) in summary.events() {
        let Event::Start(Tag::Link { dest_url, .. }) = event else {
            continue;
        };
        let path = resolve(SUMMARY, &dest_url).unwrap_or_default();
        if files.text(&path).is_none() {
            complaints.push(summary.complain(range.start, &format!("{dest_url} does not exist")));
        }
        if !named.insert(path) {
            complaints
                .push(summary.complain(range.start, &format!("{dest_url} stands here twice")));
        }
    }
    let forgotten = files.pages().filter(|page| !named.contains(page.path));
    complaints
        .extend(forgotten.map(|page| complaint(page.path, 1, "this page is not in SUMMARY.md")));
    complaints
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: (&str, &str) = ("book/src/a.md", "# A");

    fn complaints_about(summary: &str) -> Vec<String> {
        complaints(&Files::of([(SUMMARY, summary), PAGE]))
    }

    #[test]
    fn a_list_of_all_chapters_is_right() {
        assert!(complaints_about("# Summary\n\n- [A](a.md)\n").is_empty());
    }

    #[test]
    fn a_missing_page_is_found() {
        assert_eq!(
            complaints_about("# Summary\n\n- [A](a.md)\n- [B](b.md)\n"),
            ["book/src/SUMMARY.md:4: b.md does not exist"]
        );
    }

    #[test]
    fn a_page_named_twice_is_found() {
        assert_eq!(
            complaints_about("- [A](a.md)\n- [A again](a.md)\n"),
            ["book/src/SUMMARY.md:2: a.md stands here twice"]
        );
    }

    #[test]
    fn a_page_that_nobody_reaches_is_found() {
        assert_eq!(
            complaints_about("# Summary\n"),
            ["book/src/a.md:1: this page is not in SUMMARY.md"]
        );
    }
}
