//! A picture as a PPM file: the simplest format that programs read.

use common::{Image, Transfer};

/// The bytes of a PPM file of the kind P6: the line `P6`, a line of width and
/// height, the line `255`, and then red, green and blue of every pixel, row after
/// row from the top.
pub fn ppm(image: &Image) -> Vec<u8> {
    let pixels = image.to_rgb8(Transfer::Linear);
    testing::missing("the three lines before the pixels", pixels)
}
