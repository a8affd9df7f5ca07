//! Every link within the book leads somewhere.

use pulldown_cmark::{Event, Tag};

use crate::Files;
use crate::files::{PAGES, ending, resolve};
use crate::heading;
use crate::page::Page;

/// The links that lead nowhere, and those that nobody can check.
#[must_use]
pub fn complaints(files: &Files) -> Vec<String> {
    let mut complaints = Vec::new();
    for page in files.pages() {
        for (event, range) in page.events() {
            let wrong = match event {
                Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => {
                    wrong(files, page, &dest_url)
                }
                Event::Html(html) | Event::InlineHtml(html) => raw(&html),
                _ => None,
            };
            complaints.extend(wrong.map(|wrong| page.complain(range.start, &wrong)));
        }
    }
    complaints
}

fn raw(html: &str) -> Option<String> {
    let hidden = html.contains("<a ") || html.contains("<img ");
    hidden.then(|| "write links and pictures as Markdown, so that they are checked".into())
}

fn wrong(files: &Files, page: Page, link: &str) -> Option<String> {
    if link.contains("://") || link.starts_with("mailto:") {
        return None;
    }
    let (path, fragment) = link.split_once('#').unwrap_or((link, ""));
    let path = match path {
        "" => page.path.to_owned(),
        path => resolve(page.path, path).unwrap_or_default(),
    };
    if !path.starts_with(PAGES) {
        return Some(format!(
            "{link} lies outside of the book, which has to stand alone"
        ));
    }
    let Some(text) = files.text(&path) else {
        return Some(format!("{link} does not exist"));
    };
    if fragment.is_empty() {
        return None;
    }
    let target = Page { path: &path, text };
    let found = ending(&path) == "md" && heading::ids(target).contains(fragment);
    (!found).then(|| format!("{link}: {path} has no heading of that name"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn complaints_about(text: &str) -> Vec<String> {
        complaints(&Files::of([
            ("book/src/a.md", text),
            ("book/src/b.md", "# B\n\n## The end\n"),
            ("book/src/pictures/b.png", ""),
            ("README.md", ""),
        ]))
    }

    #[test]
    fn links_that_lead_somewhere_are_right() {
        let right = "# A\n\n[b](b.md), [its end](b.md#the-end), [top](#a), \
            [out](https://example.org/x#y), ![b](pictures/b.png)\n\n\
            ```text\n[code](none.md)\n```\n\nand `[code](none.md)`.\n";
        assert!(complaints_about(right).is_empty());
    }

    #[test]
    fn a_missing_page_is_found() {
        assert_eq!(
            complaints_about("\n\n[c](c.md)"),
            ["book/src/a.md:3: c.md does not exist"]
        );
    }

    #[test]
    fn a_missing_heading_is_found() {
        assert_eq!(
            complaints_about("[b](b.md#the-start)"),
            ["book/src/a.md:1: b.md#the-start: book/src/b.md has no heading of that name"]
        );
        assert_eq!(
            complaints_about("# A\n\n[here](#b)"),
            ["book/src/a.md:3: #b: book/src/a.md has no heading of that name"]
        );
    }

    #[test]
    fn a_missing_picture_is_found() {
        assert_eq!(
            complaints_about("![c](pictures/c.png)"),
            ["book/src/a.md:1: pictures/c.png does not exist"]
        );
    }

    #[test]
    fn a_link_out_of_the_book_is_found() {
        assert_eq!(
            complaints_about("[readme](../../README.md)"),
            ["book/src/a.md:1: ../../README.md lies outside of the book, which has to stand alone"]
        );
    }

    #[test]
    fn a_link_in_html_is_found() {
        assert_eq!(
            complaints_about("see <a href=\"c.md\">c</a>"),
            ["book/src/a.md:1: write links and pictures as Markdown, so that they are checked"]
        );
    }
}
