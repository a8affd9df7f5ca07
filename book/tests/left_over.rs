//! Every page is in the table of contents, and every picture is on a page.

use crate::files::{Files, PAGES, SUMMARY};

/// The pages and pictures that no reader reaches.
pub fn complaints(files: &Files) -> Vec<String> {
    let summary = files.text(SUMMARY).unwrap_or_default();
    let text: String = files.pages().map(|(_, text)| text).collect();
    let mut found = Vec::new();
    let pages = files.pages().map(|(path, _)| (path, summary));
    let pictures = files.below("book/src/pictures/");
    let pictures = pictures.map(|(path, _)| (path, text.as_str()));
    for (path, text) in pages.chain(pictures) {
        if !text.contains(&format!("]({})", &path[PAGES.len()..])) {
            found.push(format!("{path}: no link leads here"));
        }
    }
    found
}
