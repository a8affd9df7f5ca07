//! What is known of the pixels of a row. Most are seen once, and of these there is
//! nothing to remember.

use common::Color;

/// What the samples of a pixel have shown, besides their mean.
#[derive(Clone, Copy, Debug, Default)]
pub struct Pixel {
    /// How many there are; a single one lies in the middle.
    pub samples: u32,
    /// The sum of their squared distances from the mean.
    pub squares: Color,
    /// The sum of the first half of them less that of the second.
    pub halves: Color,
}

/// The pixels of a row.
#[derive(Clone, Debug)]
pub struct Row {
    /// Where in `pixels` each column is.
    places: Vec<u32>,
    /// First the one that serves for all that are seen once.
    pixels: Vec<Pixel>,
}

impl Row {
    /// So many pixels, each with the sample in its middle.
    pub fn seen_once(width: u32) -> Self {
        let once = Pixel {
            samples: 1,
            ..Pixel::default()
        };
        Self {
            places: vec![0; width as usize],
            pixels: vec![once],
        }
    }

    /// The pixel in a column.
    pub fn pixel(&self, column: u32) -> &Pixel {
        &self.pixels[self.places[column as usize] as usize]
    }

    /// The pixel in a column, which is about to be seen more often.
    pub fn pixel_mut(&mut self, column: u32) -> &mut Pixel {
        let place = &mut self.places[column as usize];
        if *place == 0 {
            *place = self.pixels.len() as u32;
            self.pixels.push(self.pixels[0]);
        }
        &mut self.pixels[*place as usize]
    }

    /// The pixels that have been seen more than once, in any order.
    pub fn seen_often(&self) -> &[Pixel] {
        &self.pixels[1..]
    }
}
