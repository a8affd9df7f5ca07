//! `set_pixel` with an early return, which counts the rows above one by one.

use crate::prelude::*;

pub fn set_pixel(image: &mut Image, x: u32, y: u32, color: Color) {
    if x >= image.size().width() || y >= image.size().height() {
        return;
    }
    let mut index = x;
    for _ in 0..y {
        index += image.size().width();
    }
    image.pixels_mut()[index as usize] = color;
}
