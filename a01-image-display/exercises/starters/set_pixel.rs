//! `set_pixel`: one pixel in a list of pixels.
//!
//! Chapter: Showing a picture, section "PaintDiagonal". To compare afterwards:
//! `common/src/image.rs`.

use common::{Color, Image};

/// Paints the pixel in column `x` and row `y`, both counted from 0 at the top left. No
/// effect outside of the picture.
///
/// `image.size()` has `width()` and `height()`; `image.pixels_mut()` is the list of all
/// pixels, row after row from the top.
pub fn set_pixel(image: &mut Image, x: u32, y: u32, color: Color) {
    testing::missing("the pixel in the list", ());
}
