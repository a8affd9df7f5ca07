//! `Anchor`: the place of a figure in a page.

/// An anchor in a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Anchor<'t> {
    /// Its first byte.
    pub start: usize,
    /// The byte behind it.
    pub end: usize,
    /// The words that name the figure.
    pub words: &'t str,
}

const OPEN: &str = "{{recorded ";
const CLOSE: &str = "}}";

impl<'t> Anchor<'t> {
    /// The first anchor in a text.
    pub fn first(text: &'t str) -> Option<Self> {
        let start = text.find(OPEN)?;
        let words = start + OPEN.len();
        let end = words + text[words..].find(CLOSE)?;
        Some(Self {
            start,
            end: end + CLOSE.len(),
            words: text[words..end].trim(),
        })
    }
}
