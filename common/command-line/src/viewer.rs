//! `Viewer`: the interface of the window, so that a build without a window contains
//! no code for one.

use common::Error;

use crate::Gallery;

/// Shows the scenes of a gallery to a person while they are rendered, and returns when the
/// person closes the window.
pub type Viewer = fn(&mut Gallery) -> Result<(), NotShown>;

/// Why nothing was shown.
#[derive(Debug, thiserror::Error)]
pub enum NotShown {
    /// There is no display, or it refuses the connection.
    #[error("{0}")]
    NoWindow(String),
    /// The picture for the window could not be made.
    #[error(transparent)]
    Failed(#[from] Error),
}
