//! A smaller picture, in which no pixel of the large one is lost.

use crate::prelude::*;

/// The picture made smaller by a whole number `n`, at least 1. Each pixel is the
/// mean of a square of n by n; squares that the right or the lower edge cuts off
/// are smaller, and there is a pixel for each of them, too.
pub fn thumbnail(image: &Image, n: u32) -> Result<Image, Error> {
    let (width, height) = (image.size().width(), image.size().height());
    missing!("the smaller picture", Image::black(image.size()), {
        let size = Size::new(width.div_ceil(n), height.div_ceil(n))?;
        Image::from_fn(size, |column, row| {
            let (left, top) = (column * n, row * n);
            let (mut sum, mut pixels) = (Color::BLACK, 0.0);
            for y in top..(top + n).min(height) {
                for x in left..(left + n).min(width) {
                    sum += image.get(x, y).unwrap_or_default();
                    pixels += 1.0;
                }
            }
            sum / pixels
        })
    })
}

testing::examples! {
    // White in the lower right corner.
    let corner = Image::from_fn(Size::new(3, 3).unwrap(), |x, y| Color::gray((x * y / 4).into()));
    let small = |n| thumbnail(corner.as_ref().unwrap(), n).unwrap();
    assert!(small(1) == *corner.as_ref().unwrap(), "by 1 nothing changes");
    assert!(small(2).size() == Size::new(2, 2).unwrap(), "a part of a square is a pixel, too");
    assert_close!(small(2).get(0, 0), Some(Color::BLACK), "four black pixels");
    assert_close!(small(2).get(1, 1), Some(Color::WHITE), "a single pixel");
}
