//! The check: new samples, which no decision has seen, show how far off the picture is.

use std::ops::AddAssign;

use super::Radiance;
use super::picture::Picture;
use super::pixel::Pixel;
use super::search::Search;

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

    /// The sum and two standard deviations, which it stays below with 95 % confidence.
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
pub struct Found {
    /// The number of pixels that were checked.
    pub checked: u64,
    /// The error of the pixels as the last check of each estimates it.
    pub known: Estimate,
    /// The error of pixels that look even, but were not drawn; and the error that was found
    /// in pixels that had looked even before. It is likely in others as well.
    pub unknown: Estimate,
}

/// Takes the samples that each pixel lacks, and compares them with those before. The goal is
/// the number of pairs that a pixel is to have, as a function of its index and itself. A pixel
/// that needs no more than the search does looks even.
pub fn check<R: Radiance>(
    picture: &mut Picture<R>,
    search: &Search,
    goal: impl Fn(usize, &Pixel) -> u32 + Sync,
) -> Found {
    let least = search.pairs;
    let unseen = search.unseen(picture.brightest());
    let rows = picture.change_rows(|picture, row, pixels| {
        let mut found = Found::default();
        let mut lacking = Vec::new();
        for (column, pixel) in pixels.iter().enumerate() {
            let goal = goal(row * pixels.len() + column, pixel);
            if goal > least && pixel.checked() <= least {
                found.unknown.add(pixel.off().min(unseen));
            }
            let (column, lacks) = (column as u32, pixel.pairs()..goal);
            if !lacks.is_empty() && (goal > least || picture.lot(column, row) < search.share) {
                lacking.push((column, lacks));
            }
        }
        let fresh = picture.sample(row, lacking.into_iter());
        for (column, fresh) in &fresh {
            let pixel = &mut pixels[*column as usize];
            let was_middle = pixel.pairs() == 0;
            pixel.check(fresh);
            if was_middle && pixel.pairs() <= least {
                let others = 1.0 / search.share - 1.0;
                found.unknown.add(pixel.off() * others);
            }
        }
        found.checked = fresh.len() as u64;
        for pixel in pixels {
            found.known.add(pixel.off());
        }
        found
    });
    let mut total = Found::default();
    for row in rows {
        total.checked += row.checked;
        total.known += row.known;
        total.unknown += row.unknown;
    }
    total
}
