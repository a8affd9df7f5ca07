//! `Viewer`: the window as the programs see it, so that a build without one
//! has none compiled in.

use common::Error;

use crate::Gallery;

/// Shows pictures to a person.
pub trait Viewer {
    /// Shows the scenes of a gallery while they are rendered, and returns when
    /// the person closes the window.
    fn show(&self, gallery: &mut Gallery) -> Result<(), NotShown>;
}

/// Why nothing was shown.
#[derive(Debug, thiserror::Error)]
pub enum NotShown {
    /// There is no display, or it refuses a connection.
    #[error("{0}")]
    NoWindow(String),
    /// There would be a window, but no picture for it.
    #[error(transparent)]
    Failed(#[from] Error),
}
