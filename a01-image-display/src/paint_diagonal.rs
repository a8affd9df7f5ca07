//! `PaintDiagonal`: the first picture, a red line on black.

use common::{Color, Error, Image, Size};

/// A picture whose pixels are red where column and row are the same, both
/// counted from the top left, and black elsewhere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PaintDiagonal {
    size: Size,
}

impl PaintDiagonal {
    /// The diagonal in a picture of this size.
    #[must_use]
    pub const fn new(size: Size) -> Self {
        Self { size }
    }

    // ANCHOR: diagonal
    /// The picture.
    pub fn image(&self) -> Result<Image, Error> {
        Image::from_fn(
            self.size,
            |x, y| {
                if x == y { Color::RED } else { Color::BLACK }
            },
        )
    }
    // ANCHOR_END: diagonal
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_are_red_where_column_and_row_are_equal() {
        for (width, height) in [(640, 480), (3, 7), (7, 3), (1, 1)] {
            let size = Size::new(width, height).unwrap();
            let image = PaintDiagonal::new(size).image().unwrap();
            let red = |color: &&Color| **color == Color::RED;
            let count = image.pixels().iter().filter(red).count();
            assert_eq!(count as u32, width.min(height), "{size}");
            let diagonal = (0..width.min(height)).map(|at| image.get(at, at));
            assert!(diagonal.eq(vec![Some(Color::RED); count]), "{size}");
        }
    }
}
