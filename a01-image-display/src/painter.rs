//! `Painter`: a picture from an array of packed pixels.

use common::{ArgumentError, Color, Error, Image, Size};

/// An array of pixels and the size that makes it a picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Painter {
    size: Size,
    pixels: Vec<u32>,
}

impl Painter {
    /// A picture of packed 0xRRGGBB pixels, row after row from the top; higher
    /// bits are ignored. Their number must be width times height.
    pub fn new(size: Size, pixels: Vec<u32>) -> Result<Self, ArgumentError> {
        if pixels.len() == size.pixels() {
            Ok(Self { size, pixels })
        } else {
            let (given, needed) = (pixels.len(), size.pixels());
            let value = format!("an array of {given} for {size}, which needs {needed}");
            let allowed = "as many as width times height";
            Err(ArgumentError::new("pixels", value, allowed))
        }
    }

    // ANCHOR: image
    /// The picture. The bytes of every packed colour are kept.
    pub fn image(&self) -> Result<Image, Error> {
        let mut image = Image::black(self.size)?;
        for (pixel, packed) in image.pixels_mut().iter_mut().zip(&self.pixels) {
            *pixel = Color::from_packed(*packed);
        }
        Ok(image)
    }
    // ANCHOR_END: image
}

#[cfg(test)]
mod tests {
    use super::*;
    use common::Transfer;

    fn size(width: u32, height: u32) -> Size {
        Size::new(width, height).unwrap()
    }

    #[test]
    fn every_colour_comes_out_as_it_went_in() {
        // All 2^24 of them, 2^16 a picture.
        for red in 0..=0xFF_u32 {
            let pixels: Vec<u32> = (0..1 << 16).map(|rest| red << 16 | rest).collect();
            let image = Painter::new(size(256, 256), pixels.clone())
                .unwrap()
                .image()
                .unwrap();
            let rgb = image.to_rgb8(Transfer::Linear);
            for (packed, rgb) in pixels.iter().zip(rgb.chunks_exact(3)) {
                assert_eq!(packed.to_be_bytes()[1..], *rgb, "{packed:06X}");
            }
        }
    }

    #[test]
    fn rows_follow_one_another_from_the_top() {
        let pixels = vec![0xFF_0000, 0x00_FF00, 0x00_00FF, 0, 0xFF_FFFF, 0xFF_FF00];
        let image = Painter::new(size(3, 2), pixels).unwrap().image().unwrap();
        assert_eq!(image.get(0, 0), Some(Color::RED));
        assert_eq!(image.get(2, 0), Some(Color::BLUE));
        assert_eq!(image.get(1, 1), Some(Color::WHITE));
    }

    #[test]
    fn an_array_of_another_length_is_refused() {
        for length in [0, 5, 7] {
            let error = Painter::new(size(3, 2), vec![0; length]).unwrap_err();
            let start = format!("pixels is an array of {length} for 3x2, which needs 6");
            assert!(error.to_string().starts_with(&start), "{error}");
        }
    }
}
