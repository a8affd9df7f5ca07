//! `diagonal` by a question to each pixel.

use crate::prelude::*;

pub fn diagonal(size: Size) -> Result<Image, Error> {
    Image::from_fn(size, |x, y| if x == y { Color::RED } else { Color::BLACK })
}
