//! A line from corner to corner, without gaps.

use common::{Color, Error, Image, Size};

/// A blue line on black, from the lower left pixel to the upper right one: one
/// pixel in every column of a wide picture, one in every row of a high one, each
/// as near to the line between the middles of both corners as a pixel can be.
pub fn line(size: Size) -> Result<Image, Error> {
    let mut image = Image::black(size)?;
    // The last column and the last row.
    let (right, bottom) = (size.width() - 1, size.height() - 1);
    testing::missing("the pixels of the line", ());
    Ok(image)
}
