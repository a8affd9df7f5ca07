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

    fn diagonal(width: u32, height: u32) -> Image {
        let size = Size::new(width, height).unwrap();
        PaintDiagonal::new(size).image().unwrap()
    }

    #[test]
    fn there_are_as_many_red_pixels_as_the_smaller_side_is_long() {
        for (width, height) in [(640, 480), (3, 7), (7, 3), (1, 1), (1, 50)] {
            let image = diagonal(width, height);
            let count = |color| image.pixels().iter().filter(|c| **c == color).count();
            let red = width.min(height) as usize;
            assert_eq!(count(Color::RED), red, "{width}x{height}");
            assert_eq!(count(Color::BLACK), image.size().pixels() - red);
        }
    }

    #[test]
    fn it_goes_down_to_the_right_from_the_top_left() {
        let image = diagonal(4, 3);
        for y in 0..3 {
            assert_eq!(image.get(y, y), Some(Color::RED));
        }
        assert_eq!(image.get(3, 2), Some(Color::BLACK));
    }
}
