//! `Viewer`: the window as the programs see it, so that a build without one
//! has none compiled in.

use crate::Size;

/// Shows pictures to a person.
pub trait Viewer {
    /// Shows a picture of packed 0xRRGGBB pixels, row after row from the top,
    /// and returns when the person closes it.
    fn show(&self, title: &str, size: Size, pixels: &[u32]) -> Result<(), NoWindow>;
}

/// Why there is no window: no display, or a refused connection to one.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub struct NoWindow(pub String);
