//! `Image`: a picture in linear colours, before it becomes bytes.

use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::{ParallelSlice, ParallelSliceMut};

use crate::{Color, Error, Size, Transfer};

/// A picture: rows from the top, pixels from the left, in linear colours.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    size: Size,
    pixels: Vec<Color>,
}

impl Image {
    /// A black picture, or an error if there is not enough memory.
    pub fn black(size: Size) -> Result<Self, Error> {
        let mut pixels = Vec::new();
        pixels
            .try_reserve_exact(size.pixels())
            .map_err(|_| Error::Memory { size })?;
        // The system provides memory at the first write to each page, so all threads share
        // that work.
        rayon::iter::repeat_n(Color::BLACK, size.pixels()).collect_into_vec(&mut pixels);
        Ok(Self { size, pixels })
    }

    /// The picture whose pixel at column `x` and row `y`, counted from the top
    /// left, is `color(x, y)`.
    pub fn from_fn(size: Size, mut color: impl FnMut(u32, u32) -> Color) -> Result<Self, Error> {
        let mut image = Self::black(size)?;
        for (y, row) in (0..).zip(image.rows_mut()) {
            for (x, pixel) in (0..).zip(row) {
                *pixel = color(x, y);
            }
        }
        Ok(image)
    }

    /// Width and height.
    #[must_use]
    pub const fn size(&self) -> Size {
        self.size
    }

    /// All pixels, row after row.
    #[must_use]
    pub fn pixels(&self) -> &[Color] {
        &self.pixels
    }

    /// All pixels, row after row, mutable.
    pub fn pixels_mut(&mut self) -> &mut [Color] {
        &mut self.pixels
    }

    /// The rows, from the top.
    pub fn rows(&self) -> impl Iterator<Item = &[Color]> {
        self.pixels.chunks_exact(self.size.width() as usize)
    }

    /// The rows, from the top, mutable.
    pub fn rows_mut(&mut self) -> impl Iterator<Item = &mut [Color]> {
        self.pixels.chunks_exact_mut(self.size.width() as usize)
    }

    /// The pixel at column `x` and row `y`; none outside of the picture.
    #[must_use]
    pub fn get(&self, x: u32, y: u32) -> Option<Color> {
        let inside = x < self.size.width() && y < self.size.height();
        inside.then(|| self.pixels[self.index(x, y)])
    }

    /// Paints the pixel at column `x` and row `y`; no effect outside of the picture.
    pub fn set(&mut self, x: u32, y: u32, color: Color) {
        if x < self.size.width() && y < self.size.height() {
            let index = self.index(x, y);
            self.pixels[index] = color;
        }
    }

    /// Paints another picture into this one, its upper left pixel at column `left` and
    /// row `top`. Pixels outside of this picture are cut off.
    pub fn paste(&mut self, left: u32, top: u32, other: &Self) {
        for (y, row) in (top..).zip(other.rows()) {
            for (x, color) in (left..).zip(row) {
                self.set(x, y, *color);
            }
        }
    }

    /// The picture with `f` applied to each pixel.
    #[must_use]
    pub fn map(mut self, f: impl Fn(Color) -> Color) -> Self {
        for pixel in &mut self.pixels {
            *pixel = f(*pixel);
        }
        self
    }

    // ANCHOR: index
    const fn index(&self, x: u32, y: u32) -> usize {
        y as usize * self.size.width() as usize + x as usize
    }
    // ANCHOR_END: index

    /// Red, green and blue bytes of all pixels.
    #[must_use]
    pub fn to_rgb8(&self, transfer: Transfer) -> Vec<u8> {
        let mut rgb = vec![0; 3 * self.pixels.len()];
        let width = self.size.width() as usize;
        let rows = rgb.par_chunks_exact_mut(3 * width);
        rows.zip(self.pixels.par_chunks_exact(width))
            .for_each(|(rgb, colors)| transfer.write_rgb8(colors, rgb));
        rgb
    }

    /// The number of pixels with NaN or infinity; 0 in a correct picture.
    #[must_use]
    pub fn count_non_finite(&self) -> usize {
        self.pixels.iter().filter(|c| !c.is_finite()).count()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbered() -> Image {
        Image::from_fn(Size::new(3, 2).unwrap(), |x, y| {
            Color::new(x.into(), y.into(), 0.0)
        })
        .unwrap()
    }

    #[test]
    fn pixels_lie_row_after_row_from_the_top_left() {
        let image = numbered();
        assert_eq!(image.pixels()[4], Color::new(1.0, 1.0, 0.0));
        assert_eq!(image.get(2, 0), Some(Color::new(2.0, 0.0, 0.0)));
        assert_eq!(image.rows().nth(1).unwrap()[0], Color::new(0.0, 1.0, 0.0));
    }

    #[test]
    fn pixels_outside_can_be_neither_read_nor_painted() {
        let mut image = numbered();
        let before = image.clone();
        for (x, y) in [(3, 0), (0, 2), (u32::MAX, u32::MAX)] {
            assert_eq!(image.get(x, y), None);
            image.set(x, y, Color::WHITE);
        }
        assert_eq!(image, before);
        image.set(2, 1, Color::WHITE);
        assert_eq!(image.get(2, 1), Some(Color::WHITE));
    }

    #[test]
    fn the_transfer_is_applied_before_rounding() {
        let gray = Image::from_fn(Size::new(1, 1).unwrap(), |_, _| Color::gray(0.25)).unwrap();
        assert_eq!(gray.to_rgb8(Transfer::Linear), [64; 3]);
        assert_eq!(gray.to_rgb8(Transfer::Srgb), [137; 3]);
    }
}
