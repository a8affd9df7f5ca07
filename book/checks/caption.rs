//! Every picture and every listing has a caption: the paragraph behind it, all
//! of it emphasised. The book's style sheet counts on that.

use pulldown_cmark::{CodeBlockKind, Event, Tag, TagEnd};

use crate::Files;
use crate::files::resolve;
use crate::include::directives;

/// The pictures and listings without a caption, and the listings whose caption
/// does not name their file.
#[must_use]
pub fn complaints(files: &Files) -> Vec<String> {
    let mut complaints = Vec::new();
    for page in files.pages() {
        let mut has_picture = false;
        for (event, range) in page.events() {
            let (what, block) = match event {
                Event::Start(Tag::Image { .. }) => {
                    has_picture = true;
                    continue;
                }
                Event::End(TagEnd::Paragraph) if std::mem::take(&mut has_picture) => {
                    ("picture", "")
                }
                Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(_)))
                    if directives(&page.text[range.clone()]).next().is_some() =>
                {
                    ("listing", &page.text[range.clone()])
                }
                _ => continue,
            };
            let behind = page.text[range.end..].trim_start().split("\n\n").next();
            let caption = behind.and_then(emphasised);
            let from = directives(block).filter_map(|(_, path)| {
                let path = path.split(':').next()?;
                resolve(page.path, path)
            });
            let wrong = match caption {
                None => Some(format!("this {what} has no *caption* behind it")),
                Some(caption) => from
                    .into_iter()
                    .find(|path| !caption.contains(path))
                    .map(|path| format!("the caption of this listing does not name *{path}*")),
            };
            complaints.extend(wrong.map(|wrong| page.complain(range.start, &wrong)));
        }
    }
    complaints
}

/// A paragraph between two stars.
fn emphasised(paragraph: &str) -> Option<&str> {
    let inner = paragraph.trim_end().strip_prefix('*')?.strip_suffix('*')?;
    (!inner.starts_with('*') && !inner.is_empty()).then_some(inner)
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
        assert_eq!(complaints_about("```rust\nassert!(true);\n```\n"), [""; 0]);
    }

    #[test]
    fn a_picture_without_a_caption_is_found() {
        let expected = ["book/src/a.md:3: this picture has no *caption* behind it"];
        for behind in ["text", "*emphasis* and text", "**bold**"] {
            let text = format!("# A\n\n![a](a.png)\n\n{behind}\n\n*more*\n");
            assert_eq!(complaints_about(&text), expected);
        }
    }

    #[test]
    fn a_listing_without_its_file_is_found() {
        assert_eq!(
            complaints_about(&format!("{LISTING}\ntext\n")),
            ["book/src/a.md:1: this listing has no *caption* behind it"]
        );
        assert_eq!(
            complaints_about(&format!("{LISTING}\n*a/src/c.rs*\n")),
            ["book/src/a.md:1: the caption of this listing does not name *a/src/b.rs*"]
        );
    }
}
