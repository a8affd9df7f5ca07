//! `diagonal`: the first picture, a red line on black.

use crate::prelude::*;

/// A picture whose pixels are red where column and row are the same, both counted from
/// the top left, and black elsewhere.
///
/// `size.width()` and `size.height()` are the numbers of columns and rows. `Image::black(size)?` is a black picture; `image.set(x, y, color)` paints a pixel.
pub fn diagonal(size: Size) -> Result<Image, Error> {
    // 1. Begin with a black picture.
    // 2. Visit the places whose column and row are the same, up to the end of the shorter side.
    // 3. Paint each of them red.
    missing!("the red diagonal", Image::black(size), {
        let mut image = Image::black(size)?;
        for at in 0..size.width().min(size.height()) {
            image.set(at, at, Color::RED);
        }
        Ok(image)
    })
}

testing::examples! {
    let image = diagonal(Size::new(4, 2).unwrap()).unwrap();
    assert_close!(image.get(0, 0), Some(Color::RED), "the upper left corner");
    assert_close!(image.get(1, 1), Some(Color::RED), "a step to the right and a step down");
    assert_close!(image.get(3, 1), Some(Color::BLACK), "the lower right corner");
}
