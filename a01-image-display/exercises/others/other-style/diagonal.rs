//! `diagonal` as a walk aslant, which ends at the first edge.

use crate::prelude::*;

pub fn diagonal(size: Size) -> Result<Image, Error> {
    let mut image = Image::black(size)?;
    let (mut x, mut y) = (0, 0);
    while x < size.width() && y < size.height() {
        image.set(x, y, Color::RED);
        x += 1;
        y += 1;
    }
    Ok(image)
}
