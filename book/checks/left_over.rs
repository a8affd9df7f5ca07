//! Every page is in the table of contents, and every picture is on a page.

use crate::Files;
use crate::files::{PAGES, SUMMARY};

/// The pages and pictures that no reader reaches.
#[must_use]
pub fn complaints(files: &Files) -> Vec<String> {
    let summary = files.text(SUMMARY).unwrap_or_default();
    let text: String = files.pages().map(|(_, text)| text).collect();
    let pages = files.pages().map(|(path, _)| (path, summary));
    let pictures = files.below("book/src/pictures/");
    let pictures = pictures.map(|(path, _)| (path, text.as_str()));
    let unreached = pages
        .chain(pictures)
        .filter(|(path, text)| !text.contains(&format!("]({})", &path[PAGES.len()..])));
    unreached
        .map(|(path, _)| format!("{path}: no link leads here"))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_unreached_page_and_an_unreached_picture_are_found() {
        let files = Files::of([
            (SUMMARY, "- [A](a.md)"),
            ("book/src/a.md", "[c](c.md) ![b](pictures/b.png)"),
            ("book/src/c.md", ""),
            ("book/src/pictures/b.png", ""),
            ("book/src/pictures/d.png", ""),
        ]);
        let expected = ["c.md", "pictures/d.png"];
        let expected = expected.map(|path| format!("{PAGES}{path}: no link leads here"));
        assert_eq!(complaints(&files), expected);
    }
}
