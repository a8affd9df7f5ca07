//! A line from corner to corner, without gaps.

use crate::prelude::*;

/// A blue line on black, from the lower left pixel to the upper right one: one
/// pixel in every column of a wide picture, one in every row of a high one, each
/// as near to the line between the middles of both corners as a pixel can be.
///
/// `image.set(x, y, color)` paints a pixel.
pub fn line(size: Size) -> Result<Image, Error> {
    let mut image = Image::black(size)?;
    // The last column and the last row.
    let (right, bottom) = (size.width() - 1, size.height() - 1);
    missing!("the pixels of the line", (), {
        // In a picture of one pixel there is no step.
        let steps = right.max(bottom).max(1);
        for i in 0..=right.max(bottom) {
            // Half of the divisor rounds to the nearest.
            let [x, up] = [right, bottom].map(|length| (i * length + steps / 2) / steps);
            image.set(x, bottom - up, Color::BLUE);
        }
    });
    Ok(image)
}

testing::examples! {
    let is_blue = |w, h, x, y| {
        let image = line(Size::new(w, h).unwrap()).unwrap();
        image.get(x, y) == Some(Color::BLUE)
    };
    assert!(is_blue(9, 5, 0, 4) && is_blue(9, 5, 8, 0), "both corners");
    assert!(is_blue(5, 9, 2, 4), "the middle of a high picture");
    assert!(!is_blue(9, 5, 0, 0), "another corner");
    assert!(is_blue(1, 1, 0, 0), "a picture of one pixel");
}
