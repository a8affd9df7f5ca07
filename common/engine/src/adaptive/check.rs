//! The check: how far off is the picture? The samples that tell this are new ones, which its
//! refinement has not seen.

use std::ops::AddAssign;

use super::Radiance;
use super::picture::Picture;
use super::pixel::{Pixel, dot};
use super::random::PixelRandom;

/// A sum of squared errors, estimated with the errors of some pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Estimate {
    /// The estimated sum, over all pixels and channels. It may be below 0.
    pub sum: f64,
    /// The variance of `sum`, or more: the sum of the squares of its terms.
    pub variance: f64,
    /// The number of pixels that were checked.
    pub pixels: u64,
}

impl Estimate {
    fn add(&mut self, term: f64) {
        self.pixels += 1;
        // A pixel that is NaN has no error; another message counts these.
        if term.is_finite() {
            self.sum += term;
            self.variance += term * term;
        }
    }
}

impl AddAssign for Estimate {
    fn add_assign(&mut self, other: Self) {
        self.sum += other.sum;
        self.variance += other.variance;
        self.pixels += other.pixels;
    }
}

/// The rows' estimates, added up in their order.
fn total(rows: Vec<Estimate>) -> Estimate {
    let mut total = Estimate::default();
    for row in rows {
        total += row;
    }
    total
}

/// Doubles the samples of all pixels that have `base` pairs.
///
/// The mean of two independent means is off by half of their difference, in the mean square.
/// Here old and new samples keep away from each other, so that it is off by less.
pub fn double<R: Radiance>(picture: &mut Picture<R>, base: u32) -> Estimate {
    total(picture.change_rows(|picture, row, pixels| {
        let is_even = |pixel: &Pixel| pixel.pairs() == base;
        let columns = (0..).zip(&*pixels).filter(|(_, pixel)| is_even(pixel));
        let wanted: Vec<_> = columns
            .map(|(column, _)| (column, base..2 * base))
            .collect();
        let fresh = picture.sample(row, picture.seed(), wanted.iter().cloned());
        let mut estimate = Estimate::default();
        for (old, new) in pixels.iter_mut().zip(&fresh) {
            if new.pairs() == base {
                // ANCHOR: even
                let apart = old.shown() - new.shown();
                estimate.add(0.25 * dot(apart, apart));
                old.merge(new);
                // ANCHOR_END: even
            }
        }
        estimate
    }))
}

/// Draws pixels with more than `base` pairs, each with this probability, and compares them
/// with two new means, each of half as many samples. The product of both differences is the
/// squared error, on average. These samples are thrown away, and counted in the second
/// result.
pub fn audit<R: Radiance>(
    picture: &Picture<R>,
    base: u32,
    probability: f64,
    round: u32,
) -> (Estimate, u64) {
    let seed = |half| {
        let random = PixelRandom::new(picture.seed(), round, half);
        (random.uniform(0) * (1_u64 << 53) as f64) as u64
    };
    let rows = picture.each_row(|row, pixels| {
        let drawn = |(column, pixel): &(u32, &Pixel)| {
            let random = PixelRandom::new(seed(0), *column, row as u32);
            pixel.pairs() > base && random.uniform(0) < probability
        };
        let drawn: Vec<_> = (0..).zip(pixels).filter(drawn).collect();
        let halves = [seed(1), seed(2)].map(|seed| {
            let half = |(column, pixel): &(u32, &Pixel)| (*column, 0..pixel.pairs() / 2);
            picture.sample(row, seed, drawn.iter().map(half))
        });
        let (mut estimate, mut samples) = (Estimate::default(), 0);
        for (column, pixel) in drawn {
            let [first, second] = halves.each_ref().map(|half| &half[column as usize]);
            // ANCHOR: audit
            let off = |fresh: &Pixel| fresh.shown() - pixel.shown();
            estimate.add(dot(off(first), off(second)) / probability);
            // ANCHOR_END: audit
            samples += u64::from(2 * (first.pairs() + second.pairs()));
        }
        (estimate, samples)
    });
    let samples = rows.iter().map(|(_, samples)| samples).sum();
    (total(rows.into_iter().map(|(e, _)| e).collect()), samples)
}
