//! `set_pixel`: one pixel in a list of pixels.

use crate::prelude::*;

/// Paints the pixel in column `x` and row `y`, from 0; outside of the picture, nothing.
///
/// `image.size()` has `width()` and `height()`; `image.pixels_mut()` is the list of pixels.
pub fn set_pixel(image: &mut Image, x: u32, y: u32, color: Color) {
    // 1. Skip a place outside of the picture.
    // 2. Count the pixels before this one: those in the rows above, and those to its left.
    // 3. Paint the pixel at that index.
    missing!("the pixel in the list", (), {
        if x < image.size().width() && y < image.size().height() {
            let width = image.size().width() as usize;
            let index = y as usize * width + x as usize;
            image.pixels_mut()[index] = color;
        }
    });
}

testing::examples! {
    let mut image = Image::black(Size::new(4, 3).unwrap()).unwrap();
    set_pixel(&mut image, 3, 0, Color::RED);
    assert_close!(image.pixels()[3], Color::RED, "three pixels from the first");
    set_pixel(&mut image, 2, 1, Color::BLUE);
    assert_close!(image.pixels()[6], Color::BLUE, "a row of four, and two pixels more");
    set_pixel(&mut image, 4, 0, Color::GREEN);
    assert_close!(image.pixels()[4], Color::BLACK, "a column that the picture does not have");
}
