//! Every picture and every listing has a caption: the paragraph behind it, all
//! of it emphasised. The book's style sheet counts on that. Pictures in a table are
//! explained by its rows.

use pulldown_cmark::{Event, Tag, TagEnd};

use crate::Files;
use crate::files::resolve;
use crate::include::directives;
use crate::page::Page;

/// The pictures and listings without a caption, and the listings whose caption
/// does not name their file.
#[must_use]
pub fn complaints(files: &Files) -> Vec<String> {
    let mut complaints = Vec::new();
    for page in files.pages() {
        let mut has_picture = false;
        for (event, range) in page.events() {
            let caption = caption(&page.text[range.end..]);
            let wrong = match event {
                Event::Start(Tag::Image { .. }) => {
                    has_picture = true;
                    None
                }
                Event::End(TagEnd::Table) => {
                    has_picture = false;
                    None
                }
                Event::End(TagEnd::Paragraph) if std::mem::take(&mut has_picture) => {
                    let missing = "this picture has no *caption* behind it";
                    caption.is_none().then(|| missing.into())
                }
                Event::Start(Tag::CodeBlock(_)) => {
                    unnamed(page, &page.text[range.clone()], caption.unwrap_or_default())
                }
                _ => None,
            };
            complaints.extend(wrong.map(|wrong| page.complain(range.start, &wrong)));
        }
    }
    complaints
}

/// The paragraph that a text begins with, if all of it stands between stars.
fn caption(behind: &str) -> Option<&str> {
    let paragraph = behind.trim_start().split("\n\n").next()?.trim_end();
    let inner = paragraph.strip_prefix('*')?.strip_suffix('*')?;
    (!inner.is_empty() && !inner.contains('*')).then_some(inner)
}

/// The file of a listing that its caption does not name.
fn unnamed(page: Page, listing: &str, caption: &str) -> Option<String> {
    let targets = directives(listing).map(|(_, target)| target);
    let paths = targets.filter_map(|target| resolve(page.path, target.split(':').next()?));
    let mut unnamed = paths.filter(|path| !caption.contains(path));
    let path = unnamed.next()?;
    Some(format!("this listing has no caption *{path}* behind it"))
}

#[cfg(test)]
mod tests {
    use super::*;

    const LISTING: &str = "```rust,ignore\n{{#include ../../a/src/b.rs:c}}\n```\n";

    fn complaints_about(text: &str) -> Vec<String> {
        complaints(&Files::of([("book/src/a.md", text)]))
    }

    #[test]
    fn captions_are_right() {
        let text = format!("![a](a.png)\n\n*A, seen\nfrom `b`*\n\n{LISTING}\n*a/src/b.rs*\n");
        assert_eq!(complaints_about(&text), [""; 0]);
        let table = "| a |\n|---|\n| ![b](c.png) |\n\nd\n";
        assert_eq!(complaints_about(table), [""; 0]);
        assert_eq!(complaints_about("```rust\nassert!(true);\n```\n"), [""; 0]);
    }

    #[test]
    fn a_picture_without_a_caption_is_found() {
        let expected = ["book/src/a.md:3: this picture has no *caption* behind it"];
        for behind in ["text", "*emphasis* and text", "*one* and *two*", "**bold**"] {
            let text = format!("# A\n\n![a](a.png)\n\n{behind}\n\n*more*\n");
            assert_eq!(complaints_about(&text), expected);
        }
    }

    #[test]
    fn a_listing_without_its_file_is_found() {
        assert_eq!(
            complaints_about(&format!("{LISTING}\ntext\n")),
            ["book/src/a.md:1: this listing has no caption *a/src/b.rs* behind it"]
        );
        assert_eq!(
            complaints_about(&format!("{LISTING}\n*a/src/c.rs*\n")),
            ["book/src/a.md:1: this listing has no caption *a/src/b.rs* behind it"]
        );
    }
}
