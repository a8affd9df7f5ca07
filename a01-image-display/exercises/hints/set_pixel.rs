//! `set_pixel`: one pixel in a list of pixels.

use crate::prelude::*;

/// Paints the pixel in column `x` and row `y`, from 0; outside of the picture, nothing.
///
/// `image.size()` has `width()` and `height()`; `image.pixels_mut()` is the list of pixels.
pub fn set_pixel(image: &mut Image, x: u32, y: u32, color: Color) {
    if x < image.size().width() && y < image.size().height() {
        let width = image.size().width() as usize;
        let index = y as usize * width + x as usize;
        image.pixels_mut()[index] = color;
    }
}
