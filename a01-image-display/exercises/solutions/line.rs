//! A line from corner to corner, without gaps.

use common::{Color, Error, Image, Size};

/// A blue line on black, from the lower left pixel to the upper right one: one
/// pixel in every column of a wide picture, one in every row of a high one, each
/// as near to the line between the middles of both corners as a pixel can be.
pub fn line(size: Size) -> Result<Image, Error> {
    let mut image = Image::black(size)?;
    // The last column and the last row.
    let (right, bottom) = (size.width() - 1, size.height() - 1);
    let steps = right.max(bottom);
    // Half of the divisor rounds to the nearest, and u64 holds the product.
    let share = |i: u32, length: u32| {
        let (i, length, steps) = (u64::from(i), u64::from(length), u64::from(steps.max(1)));
        ((i * length + steps / 2) / steps) as u32
    };
    for i in 0..=steps {
        image.set(share(i, right), bottom - share(i, bottom), Color::BLUE);
    }
    Ok(image)
}
