//! `set_pixel`: the lesson's own.

use common::{Color, Image};

pub fn set_pixel(image: &mut Image, x: u32, y: u32, color: Color) {
    image.set(x, y, color);
}
