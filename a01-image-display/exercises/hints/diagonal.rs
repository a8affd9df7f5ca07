//! `diagonal`: the first picture, a red line on black.

use crate::prelude::*;

/// A picture whose pixels are red where column and row are the same, both counted from
/// the top left, and black elsewhere.
///
/// `Image::black(size)?` is a black picture; `image.set(x, y, color)` paints a pixel.
pub fn diagonal(size: Size) -> Result<Image, Error> {
    let mut image = Image::black(size)?;
    for at in 0..size.width().min(size.height()) {
        image.set(at, at, Color::RED);
    }
    Ok(image)
}
