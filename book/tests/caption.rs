//! Every picture and every listing has a caption: the paragraph behind it, all of it
//! emphasised, as the book's style sheet expects. Pictures in a table need none.

use crate::files::{Files, blocks, complaint, resolve};
use crate::include::directives;

/// The pictures and listings without a caption, and the listings whose caption does
/// not name their file.
pub fn complaints(files: &Files) -> Vec<String> {
    let mut complaints = Vec::new();
    for (page, text) in files.pages() {
        let blocks = blocks(text);
        for (index, &(at, block)) in blocks.iter().enumerate() {
            let caption = blocks.get(index + 1).and_then(|(_, next)| emphasised(next));
            let wrong = if block.starts_with("```") {
                unnamed(page, block, caption.unwrap_or_default())
            } else {
                let has_picture = block.contains("![") && !block.starts_with('|');
                let is_wrong = has_picture && caption.is_none();
                is_wrong.then(|| "this picture has no *caption* behind it".to_owned())
            };
            complaints.extend(wrong.map(|wrong| complaint(page, text, at, &wrong)));
        }
    }
    complaints
}

/// The text of a paragraph that is emphasised as a whole.
fn emphasised(paragraph: &str) -> Option<&str> {
    let inner = paragraph.strip_prefix('*')?.strip_suffix('*')?;
    (!inner.is_empty() && !inner.contains('*')).then_some(inner)
}

/// The complaint about a listing whose caption does not name its file.
fn unnamed(page: &str, listing: &str, caption: &str) -> Option<String> {
    let targets = directives(listing).map(|(_, target)| target);
    let mut paths = targets.filter_map(|target| resolve(page, target.split(':').next()?));
    let path = paths.find(|path| !caption.contains(path))?;
    Some(format!("this listing has no caption *{path}* behind it"))
}

mod tests {
    use super::*;

    const LISTING: &str = "```rust,ignore\n{{#include ../../a/src/b.rs:c}}\n```\n";

    #[test]
    fn missing_captions_are_found() {
        let right = format!("![a](a.png)\n\n*A, seen\nfrom `b`*\n\n{LISTING}\n*a/src/b.rs*\n");
        let table =
            "| a |\n|---|\n| ![b](c.png) |\n\nd\n\n```rust\nassert!(true);\n\nvec![0]\n```\n";
        let picture = |behind| format!("# A\n\n![a](a.png)\n\n{behind}\n");
        let listing = |behind| format!("{LISTING}\n{behind}\n");
        let no_caption = "book/src/a.md:3: this picture has no *caption* behind it";
        let no_file = "book/src/a.md:1: this listing has no caption *a/src/b.rs* behind it";
        for (text, expected) in [
            (right, None),
            (table.to_owned(), None),
            (picture("text"), Some(no_caption)),
            (picture("*emphasis* and text"), Some(no_caption)),
            (picture("*one* and *two*"), Some(no_caption)),
            (picture("**bold**"), Some(no_caption)),
            (listing("text"), Some(no_file)),
            (listing("*a/src/c.rs*"), Some(no_file)),
        ] {
            let found = complaints(&Files::of([("book/src/a.md", &text)]));
            assert!(found.iter().eq(expected.iter()), "{text}: {found:?}");
        }
    }
}
