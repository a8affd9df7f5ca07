//! `sensitivity`: how the colour of a pixel changes with a number of its scene.
//!
//! The types are here, and the numerics of one number; which numbers a scene has, and what a pixel
//! is with another value, is the business of those who know the scene.

mod response;

use std::ops::Range;

use crate::{Color, Error, Image, Size};

pub use response::{Edge, Response};

/// The unit of a number of a scene, from which the step follows that moves it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unit {
    /// A length, or a coordinate of a place, in the unit of the scene.
    Length,
    /// An angle in degrees.
    Degree,
    /// A coordinate of a direction of this length, which has no unit.
    Direction(f64),
    /// A factor or an exponent, which has no unit.
    Factor,
    /// A channel of a colour, in linear light: 1 is the brightest that a picture shows.
    Channel,
    /// A whole number, such as a number of copies. A colour has no derivative by it.
    Whole,
}

/// A number of a scene file, and where it stands.
#[derive(Clone, Debug, PartialEq)]
pub struct NumberPlace {
    /// Its line, from 1.
    pub line: usize,
    /// Its columns, in characters from 1, without the one behind it. A colour in a text has three
    /// numbers: those of digits have two columns each, or one, and those of a name have the whole
    /// name.
    pub columns: Range<usize>,
    /// Its bytes in the text of the file.
    pub bytes: Range<usize>,
    /// The first byte of its value, which may be a list of several numbers.
    pub at: usize,
    /// Its table, such as `[[sphere]] #2`: the second one in the file, or in its group.
    pub table: String,
    /// Its key, and which of the numbers of this key it is, such as `center x`.
    pub key: String,
    /// Its value; of a colour in a text, the channel in linear light.
    pub value: f64,
    /// Its unit.
    pub unit: Unit,
}

/// A number, and how a pixel changes with it.
#[derive(Clone, Debug, PartialEq)]
pub struct Influence {
    /// The number.
    pub number: NumberPlace,
    /// How the pixel changes.
    pub response: Response,
}

/// Sorts influences: the edges first, by the size of the jump, then by the largest change of a
/// channel per unit, then in the order of the file.
pub fn sort_by_strength(influences: &mut [Influence]) {
    influences.sort_by(|a, b| {
        let [left, right] = [a, b].map(|influence| influence.response.strength());
        right
            .partial_cmp(&left)
            .unwrap_or(std::cmp::Ordering::Equal)
    });
}

/// The pixels that depend on some numbers of a scene.
#[derive(Clone, Debug)]
pub struct DependentPixels {
    /// Width and height of the picture.
    pub size: Size,
    /// How much each pixel changes, row after row from the top: the largest change of a channel when
    /// one of the numbers moves by its step; 0 for a pixel that does not change at all.
    pub strengths: Vec<f64>,
    /// The numbers, and the steps by which they were moved.
    pub numbers: Vec<(NumberPlace, f64)>,
}

impl DependentPixels {
    /// The number of pixels that change.
    #[must_use]
    pub fn count(&self) -> usize {
        self.strengths.iter().filter(|it| **it > 0.0).count()
    }

    /// The largest strength.
    #[must_use]
    pub fn largest(&self) -> f64 {
        self.strengths.iter().copied().fold(0.0, f64::max)
    }

    /// The strength of each pixel from 0 to 1: 1 for the largest change, 1/3 less for each tenth of it,
    /// but at least 1/10 for a pixel that changes at all.
    #[must_use]
    pub fn heat(&self) -> Vec<f64> {
        let largest = self.largest();
        let heat = |strength: &f64| {
            if *strength > 0.0 {
                (1.0 + libm::log10(strength / largest) / 3.0).max(0.1)
            } else {
                0.0
            }
        };
        self.strengths.iter().map(heat).collect()
    }

    /// A heat map over the grey picture: red where pixels change a little, over orange, to white where
    /// they change most. A pixel that does not change is grey.
    pub fn over(&self, picture: &Image) -> Result<Image, Error> {
        let heat = self.heat();
        let width = self.size.width() as usize;
        Image::from_fn(self.size, |x, y| {
            let heat = heat
                .get(y as usize * width + x as usize)
                .copied()
                .unwrap_or(0.0);
            let color = picture.get(x, y).unwrap_or_default();
            let [r, g, b] = color.channels().map(|channel| channel.clamp(0.0, 1.0));
            // The luminance of linear light (ITU-R BT.709).
            let grey = 0.5 * (0.2126 * r + 0.7152 * g + 0.0722 * b);
            if heat == 0.0 {
                return Color::gray(grey);
            }
            Color::new(
                (0.4 + 1.2 * heat).min(1.0),
                heat * heat.sqrt(),
                heat * heat * heat * heat,
            )
        })
    }
}
