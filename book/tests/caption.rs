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
