//! Pixels, pictures and the window that shows them.
//!
//! Everything the later stages compute ends as an [`Image`](common::Image).
//! Here images are made by hand, pixel by pixel, so that the path from a colour
//! to the screen is clear before the first ray.

mod adapter;
mod canvas;
mod paint_diagonal;
mod painter;
mod scenes;
mod show_image;
#[cfg(feature = "window")]
mod window;

pub use crate::adapter::stage;
pub use canvas::Canvas;
pub use paint_diagonal::PaintDiagonal;
pub use painter::Painter;
pub use show_image::ShowImage;

/// The window in which the programs of all stages show their pictures; `None`
/// in a build without the feature `window`.
#[cfg(not(target_family = "wasm"))]
#[must_use]
pub fn viewer() -> Option<command_line::Viewer> {
    #[cfg(feature = "window")]
    return Some(window::show);
    #[cfg(not(feature = "window"))]
    return None;
}
