//! A picture as a PPM file: the simplest format that programs read.

use crate::prelude::*;

/// The bytes of a PPM file of the kind P6: the line `P6`, a line of width and
/// height, the line `255`, and then red, green and blue of every pixel, row after
/// row from the top.
///
/// `image.size()` has `width()` and `height()`.
pub fn ppm(image: &Image) -> Vec<u8> {
    let pixels = image.to_rgb8(Transfer::Linear);
    missing!("the three lines before the pixels", pixels, {
        let (width, height) = (image.size().width(), image.size().height());
        let header = format!("P6\n{width} {height}\n255\n");
        [header.into_bytes(), pixels].concat()
    })
}

testing::examples! {
    let file = |w, h, color| {
        let size = Size::new(w, h).unwrap();
        ppm(&Image::from_fn(size, |_, _| color).unwrap())
    };
    assert!(file(1, 1, Color::WHITE) == b"P6\n1 1\n255\n\xff\xff\xff", "a white pixel");
    assert!(file(3, 2, Color::BLACK).starts_with(b"P6\n3 2\n255\n"), "three columns, two rows");
    assert_close!(file(3, 2, Color::BLACK).len(), 11 + 3 * 3 * 2, "three bytes per pixel");
}
