//! How far two pictures of one scene lie apart: the times of two programs can be
//! compared only where both compute the same picture.

use std::fmt;
use std::path::Path;

use common::{Error, picture_file};

/// The largest difference of a channel, of 255, that still counts as the same.
const SAME: f64 = 8.0;

/// The difference of two pictures.
pub struct Difference {
    /// The share of pixels of which a channel differs by more than [`SAME`].
    different: f64,
    /// The mean over all channels, of 255.
    mean: f64,
}

impl Difference {
    /// Compares two picture files of the same size.
    pub fn between(a: &Path, b: &Path) -> Result<Self, Error> {
        let (a, b) = (picture_file::open(a)?, picture_file::open(b)?);
        let (mut different, mut sum) = (0, 0.0);
        for (a, b) in a.pixels().iter().zip(b.pixels()) {
            let apart = (*a - *b).channels().map(|channel| 255.0 * channel.abs());
            different += usize::from(apart.iter().any(|channel| *channel > SAME));
            sum += apart.iter().sum::<f64>();
        }
        let pixels = a.size().pixels() as f64;
        Ok(Self {
            different: different as f64 / pixels,
            mean: sum / (3.0 * pixels),
        })
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:.2} % ({:.2})", 100.0 * self.different, self.mean)
    }
}
