//! `set_pixel` by rows: the row of this number, and its pixel of that number.

use crate::prelude::*;

pub fn set_pixel(image: &mut Image, x: u32, y: u32, color: Color) {
    let width = image.size().width() as usize;
    let mut rows = image.pixels_mut().chunks_mut(width);
    if let Some(pixel) = rows.nth(y as usize).and_then(|row| row.get_mut(x as usize)) {
        *pixel = color;
    }
}
