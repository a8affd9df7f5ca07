//! Every page is in the table of contents, every picture is on a page, and every file that
//! a page names exists.

use crate::files::{Files, PAGES, SUMMARY, complaint, ending};

/// The pages and pictures that no reader reaches, and the names of files that do not exist.
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
    for (page, text) in files.pages() {
        let mut at = 0;
        for span in text.split('`') {
            if is_file(span) && files.text(span).is_none() {
                found.push(complaint(
                    page,
                    text,
                    at,
                    &format!("there is no file {span}"),
                ));
            }
            at += span.len() + 1;
        }
    }
    found
}

/// Whether a part of a page is the path of a source file from the top of the repository.
fn is_file(span: &str) -> bool {
    let tops = ["a0", "book/", "common/"];
    let is_path = ending(span) == "rs" && !span.contains(char::is_whitespace);
    is_path && span.contains("/src/") && tops.iter().any(|top| span.starts_with(top))
}
