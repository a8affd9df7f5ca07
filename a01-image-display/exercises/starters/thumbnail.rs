//! A smaller picture, in which no pixel of the large one is lost.

use common::{Color, Error, Image, Size};

/// The picture made smaller by a whole number `n`, at least 1. Each pixel is the
/// mean of a square of n by n; squares that the right or the lower edge cuts off
/// are smaller, and there is a pixel for each of them, too.
pub fn thumbnail(image: &Image, n: u32) -> Result<Image, Error> {
    let (width, height) = (image.size().width(), image.size().height());
    testing::missing("the smaller picture", Image::black(image.size()))
}
