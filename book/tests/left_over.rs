//! Every page is in the table of contents, every picture is on a page, and every file that
//! a page names exists.

use crate::files::{Files, PAGES, SUMMARY, blocks, complaint, ending};

/// The pages and pictures that no reader reaches, and the names of files that do not exist.
pub fn complaints(files: &Files) -> Vec<String> {
    let summary = files.text(SUMMARY).unwrap_or_default();
    let text: String = files.pages().map(|(_, text)| text).collect();
    let pages = files.pages().map(|(path, _)| (path, summary));
    let pictures = files.below("book/src/pictures/");
    let pictures = pictures.map(|(path, _)| (path, text.as_str()));
    let unreached = pages
        .chain(pictures)
        .filter(|(path, text)| !text.contains(&format!("]({})", &path[PAGES.len()..])));
    let unreached = unreached.map(|(path, _)| format!("{path}: no link leads here"));

    let paragraphs = files.pages().flat_map(|(page, text)| {
        let paragraphs = blocks(text).into_iter();
        let paragraphs = paragraphs.filter(|(_, block)| !block.starts_with("```"));
        paragraphs.map(move |(at, block)| (page, text, at, block))
    });
    let missing = paragraphs.flat_map(|(page, text, at, block)| {
        let spans = block.split('`').skip(1).step_by(2);
        let is_missing = |span: &&str| is_file(span) && files.text(span).is_none();
        let complaint = move |span| complaint(page, text, at, &format!("there is no file {span}"));
        spans.filter(is_missing).map(complaint)
    });
    unreached.chain(missing).collect()
}

/// Whether a code span is the path of a source file from the top of the repository.
fn is_file(span: &str) -> bool {
    let tops = ["a0", "book/", "common/"];
    ending(span) == "rs" && span.contains("/src/") && tops.iter().any(|top| span.starts_with(top))
}
