//! The check: new samples show the error of the picture by their difference from those before.

use std::ops::AddAssign;

use super::pilot::Pilot;
use super::pixel::Pixel;
use super::sampled_picture::SampledPicture;

/// An estimated sum of squared errors.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Estimate {
    /// The sum over all pixels and channels.
    pub sum: f64,
    /// The variance of `sum`, or more: the sum of the squares of its terms.
    pub variance: f64,
}

impl Estimate {
    /// Adds the estimated squared error of a pixel.
    pub fn add(&mut self, term: f64) {
        self.sum += term;
        self.variance += term * term;
    }

    /// The upper end of the confidence interval of 95 %: the sum and two standard deviations.
    pub fn largest(&self) -> f64 {
        self.sum + 2.0 * self.variance.sqrt()
    }
}

impl AddAssign for Estimate {
    fn add_assign(&mut self, other: Self) {
        self.sum += other.sum;
        self.variance += other.variance;
    }
}

/// The result of a check.
#[derive(Clone, Copy, Debug, Default)]
pub struct Checked {
    /// The number of pixels with new samples.
    pub pixels: u64,
    /// The error of the pixels as the last check of each estimates it.
    pub known: Estimate,
    /// The error of pixels that keep the sample in their middle; and the error found in pixels
    /// that had only pilot samples before. It is likely in others as well.
    pub unrefined: Estimate,
}

/// Takes the samples that each pixel lacks, and compares them with those before. The goal is
/// the number of pairs that a pixel is to have, as a function of its index and itself; no object
/// that no sample met is brighter than `brightest`.
pub fn check(
    picture: &mut SampledPicture,
    pilot: &Pilot,
    brightest: f64,
    goal: impl Fn(usize, &Pixel) -> u32 + Sync,
) -> Checked {
    let min_pairs = pilot.pairs;
    let unseen = pilot.unseen(brightest);
    let rows = picture.change_rows(&|picture, row, pixels| {
        let mut checked = Checked::default();
        let mut lacking = Vec::new();
        for (column, pixel) in pixels.iter().enumerate() {
            let goal = goal(row * pixels.len() + column, pixel);
            if goal > min_pairs && pixel.checked_pairs() <= min_pairs {
                checked.unrefined.add(pixel.squared_error().min(unseen));
            }
            let (column, lacks) = (column as u32, pixel.pairs()..goal);
            let is_chosen = || picture.choice(column, row) < pilot.fraction;
            if !lacks.is_empty() && (goal > min_pairs || is_chosen()) {
                lacking.push((column, lacks));
            }
        }
        let new = picture.sample(row, lacking.into_iter());
        for (column, new) in &new {
            let pixel = &mut pixels[*column as usize];
            let had_only_middle = pixel.pairs() == 0;
            pixel.check(new);
            if had_only_middle && pixel.pairs() <= min_pairs {
                let others = 1.0 / pilot.fraction - 1.0;
                checked.unrefined.add(pixel.squared_error() * others);
            }
        }
        checked.pixels = new.len() as u64;
        for pixel in pixels {
            checked.known.add(pixel.squared_error());
        }
        checked
    });
    let mut total = Checked::default();
    for row in rows {
        total.pixels += row.pixels;
        total.known += row.known;
        total.unrefined += row.unrefined;
    }
    total
}
