//! `Values`: the values of a picture in a channel, and what they are in a region. They are linear, from 0 to 1, as the
//! picture's bytes have them.

use std::collections::BTreeMap;

use common::{Color, Image, Size};

/// One of the three channels.
#[derive(Clone, Copy, Debug)]
pub enum Channel {
    Red,
    Green,
    Blue,
}

/// A rectangle of pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Region {
    pub x: u32,
    pub y: u32,
    pub width: u32,
    pub height: u32,
}

impl Region {
    pub fn is_inside(self, size: Size) -> bool {
        let fits = |from: u32, count: u32, all: u32| {
            count > 0 && from.checked_add(count).is_some_and(|end| end <= all)
        };
        fits(self.x, self.width, size.width()) && fits(self.y, self.height, size.height())
    }

    pub fn pixels(self) -> impl Iterator<Item = (u32, u32)> {
        let columns = self.x..self.x + self.width;
        let rows = self.y..self.y + self.height;
        rows.flat_map(move |y| columns.clone().map(move |x| (x, y)))
    }
}

/// The values of a picture in one channel, or the means of the three.
#[derive(Clone, Copy)]
pub struct Values<'a> {
    pub image: &'a Image,
    pub channel: Option<Channel>,
}

impl Values<'_> {
    /// The value of a pixel in the picture.
    pub fn at(&self, (x, y): (u32, u32)) -> f64 {
        let Color { r, g, b } = self.image.get(x, y).unwrap_or_default();
        match self.channel {
            Some(Channel::Red) => r,
            Some(Channel::Green) => g,
            Some(Channel::Blue) => b,
            None => (r + g + b) / 3.0,
        }
    }

    /// The value at a point in the picture, interpolated between the centres of the pixels around it.
    pub fn between(&self, [x, y]: [f64; 2]) -> f64 {
        let (left, top) = (x as u32, y as u32);
        let (across, down) = (x.fract(), y.fract());
        let mut value = 0.0;
        for (y, of_row) in [(top, 1.0 - down), (top + 1, down)] {
            for (x, of_column) in [(left, 1.0 - across), (left + 1, across)] {
                let weight = of_row * of_column;
                if weight > 0.0 {
                    value += weight * self.at((x, y));
                }
            }
        }
        value
    }

    pub fn mean(&self, region: Region) -> f64 {
        let sum: f64 = region.pixels().map(|pixel| self.at(pixel)).sum();
        sum / region.pixels().count() as f64
    }

    pub fn greatest(&self, region: Region) -> f64 {
        let values = region.pixels().map(|pixel| self.at(pixel));
        values.fold(f64::NEG_INFINITY, f64::max)
    }

    pub fn least(&self, region: Region) -> f64 {
        let values = region.pixels().map(|pixel| self.at(pixel));
        values.fold(f64::INFINITY, f64::min)
    }

    /// The share of pixels that have the value of the pixel below, of those above the last row.
    pub fn alike(&self, region: Region) -> f64 {
        let (mut count, mut alike) = (0.0, 0.0);
        for (x, y) in region.pixels() {
            if y + 1 < region.y + region.height {
                count += 1.0;
                alike += f64::from(u8::from(self.at((x, y)) == self.at((x, y + 1))));
            }
        }
        alike / count
    }

    /// The greatest share of one value, where a pixel of the last row costs 1, and one of each row above 1 more.
    pub fn load(&self, region: Region) -> f64 {
        let mut work = BTreeMap::new();
        let mut all = 0.0;
        for (x, y) in region.pixels() {
            let cost = f64::from(region.y + region.height - y);
            *work.entry(self.at((x, y)).to_bits()).or_insert(0.0) += cost;
            all += cost;
        }
        work.into_values().fold(0.0, f64::max) / all
    }

    /// The differences from exact values, row by row.
    pub fn errors(&self, region: Region, exact: impl Fn((u32, u32)) -> f64) -> Vec<f64> {
        let pixels = region.pixels();
        pixels.map(|pixel| self.at(pixel) - exact(pixel)).collect()
    }
}

/// The pixels whose bytes differ between two pictures of the same size: how many they are, and the rectangle
/// around them.
pub fn different(a: &Image, b: &Image) -> (usize, Option<Region>) {
    let mut count = 0;
    let (mut low, mut high) = ((u32::MAX, u32::MAX), (0, 0));
    for (y, (a, b)) in (0..).zip(a.rows().zip(b.rows())) {
        for (x, (a, b)) in (0..).zip(a.iter().zip(b)) {
            if a.to_bytes() != b.to_bytes() {
                count += 1;
                low = (low.0.min(x), low.1.min(y));
                high = (high.0.max(x), high.1.max(y));
            }
        }
    }
    let around = (count > 0).then(|| Region {
        x: low.0,
        y: low.1,
        width: high.0 - low.0 + 1,
        height: high.1 - low.1 + 1,
    });
    (count, around)
}

/// The root mean square of errors.
pub fn root_mean_square(errors: &[f64]) -> f64 {
    let squares = errors.iter().map(|error| error * error);
    (squares.sum::<f64>() / errors.len() as f64).sqrt()
}

/// The greatest difference between the steps from one mean to the next.
pub fn growth(means: &[f64]) -> f64 {
    let steps: Vec<_> = means.windows(2).map(|two| two[1] - two[0]).collect();
    let greatest = steps.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let least = steps.iter().copied().fold(f64::INFINITY, f64::min);
    greatest - least
}
