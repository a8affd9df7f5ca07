//! `Allocation`: how many samples each pixel is to have.
//!
//! Where an edge crosses a pixel, its squared error is about `2 V n^(-3/2)`: `V` is the
//! variance of a sample and `n` the number of samples, of which only some √n lie next to the
//! edge (Mitchell, Consequences of Stratified Sampling in Graphics, 1996). For a given sum of
//! these errors, the sum of all `n` is least if `n` grows as `V^(2/5)`: then one more sample
//! gains equally much everywhere.

use rayon::iter::ParallelIterator;
use rayon::slice::ParallelSlice;

/// Doubts are sorted by their exponents and the two binary digits behind.
const DIGITS: u32 = f32::MANTISSA_DIGITS - 1 - 2;
const CLASSES: usize = 1 << (31 - DIGITS);
/// Classes of twice as many samples: `V` grows by 2^(5/2).
const PER_DOUBLING: usize = 10;

fn class(doubt: f32) -> usize {
    (doubt.to_bits() >> DIGITS) as usize % CLASSES
}

/// The doubt in the middle of a class.
fn doubt_of(class: usize) -> f64 {
    f32::from_bits((class as u32) << DIGITS | 1 << (DIGITS - 1)).into()
}

/// How many samples are wanted.
#[derive(Clone, Copy, Debug)]
pub struct Wish {
    /// The pairs that each pixel has at least and at most.
    pub least: u32,
    pub most: u32,
    /// The sum of the expected squared errors is to be at most this.
    pub aim: f64,
    /// This many samples more than the least are free: they make the error smaller than
    /// the aim.
    pub free: f64,
}

/// No smaller a sum of squared errors than this share of the aim is worth free samples.
const FINEST: f64 = 1.0 / 16.0;

/// The pairs of samples for each class of doubts.
pub struct Allocation {
    wish: Wish,
    /// The first class with twice as many samples as the least. All below have the least.
    first: usize,
}

impl Allocation {
    /// The allocation for these doubts that comes up to the wish, if that can be.
    pub fn new(doubts: &[f32], wish: Wish) -> Self {
        let counts = counts(doubts);
        let expect = |first| Self { wish, first }.expect(&counts);
        // With each smaller `first` the error falls, and the number of samples grows.
        let is_too_little = |first: usize| {
            let (error, _) = expect(first);
            let (_, samples) = expect(first - 1);
            error > wish.aim || (samples <= wish.free && error > FINEST * wish.aim)
        };
        let (mut enough, mut too_little) = (1, CLASSES + 1);
        while too_little - enough > 1 {
            let middle = usize::midpoint(enough, too_little);
            if is_too_little(middle) {
                too_little = middle;
            } else {
                enough = middle;
            }
        }
        Self {
            wish,
            first: enough,
        }
    }

    /// The sum of the expected squared errors, and the number of samples beyond the least.
    fn expect(&self, counts: &[u64]) -> (f64, f64) {
        let (mut sum, mut beyond) = (0.0, 0.0);
        for (class, count) in counts.iter().enumerate().filter(|(_, count)| **count > 0) {
            let (pairs, count) = (self.pairs_of(class), *count as f64);
            let samples = 2.0 * f64::from(pairs);
            sum += count * 2.0 * doubt_of(class) / (samples * samples.sqrt());
            beyond += count * 2.0 * f64::from(pairs - self.wish.least);
        }
        (sum, beyond)
    }

    fn pairs_of(&self, class: usize) -> u32 {
        let Wish { least, most, .. } = self.wish;
        let above = (class + 1).saturating_sub(self.first);
        let doublings = above.div_ceil(PER_DOUBLING).min(31) as u32;
        least.saturating_mul(1 << doublings).min(most).max(least)
    }

    /// The pairs that a pixel of this doubt is to have.
    pub fn pairs(&self, doubt: f32) -> u32 {
        self.pairs_of(class(doubt))
    }
}

/// The number of pixels of each class, without those of no doubt.
fn counts(doubts: &[f32]) -> Vec<u64> {
    let count = |doubts: &[f32]| {
        let mut counts = vec![0; CLASSES];
        for doubt in doubts.iter().filter(|doubt| **doubt > 0.0) {
            counts[class(*doubt)] += 1;
        }
        counts
    };
    let add = |a: Vec<u64>, b: Vec<u64>| a.iter().zip(&b).map(|(a, b)| a + b).collect();
    let parts = doubts.par_chunks(1 << 14).map(count);
    parts.reduce(|| vec![0; CLASSES], add)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Doubts of 1/1024 to 1, a thousand of each; the expected error, and the most pairs.
    fn result(most: u32, aim: f64, free: f64) -> (f64, u32) {
        let wish = Wish {
            least: 3,
            most,
            aim,
            free,
        };
        let powers = (0..=10).map(|i| 1.0 / (1 << i) as f32);
        let doubts: Vec<_> = powers.flat_map(|doubt| [doubt; 1000]).collect();
        let allocation = Allocation::new(&doubts, wish);
        assert_eq!(allocation.pairs(0.0), 3);
        let error = |doubt: &f32| {
            let samples = f64::from(2 * allocation.pairs(*doubt));
            2.0 * f64::from(*doubt) / (samples * samples.sqrt())
        };
        (doubts.iter().map(error).sum(), allocation.pairs(1.0))
    }

    /// A class is an eighth wide on both sides of its middle.
    #[test]
    fn the_expected_error_comes_near_the_aim() {
        for aim in [100.0, 1.0, 0.01] {
            let (error, _) = result(1 << 20, aim, 0.0);
            assert!(error < aim * 1.13 && error > aim / 2.0, "{error} of {aim}");
            let (smaller, _) = result(1 << 20, aim, 1e9);
            assert!(smaller < aim / 12.0, "{smaller} of {aim}");
        }
        assert_eq!(result(100, 1e9, 0.0).1, 3);
        assert_eq!(result(100, 1e-9, 0.0).1, 100);
    }
}
