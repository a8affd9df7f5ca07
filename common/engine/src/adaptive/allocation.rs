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

/// The pairs of samples for each class of doubts.
pub struct Allocation {
    pairs: Vec<u32>,
    /// The expected squared errors, added up over the pixels, and the squares of these.
    error: f64,
    squares: f64,
}

impl Allocation {
    /// The allocation with which the expected squared errors add up to at most `aim`, if that
    /// can be. No pixel has fewer pairs than `least` or more than `most`.
    pub fn new(doubts: &[f32], least: u32, most: u32, aim: f64) -> Self {
        let counts = counts(doubts);
        let mut allocation = Self {
            pairs: vec![least; CLASSES],
            error: 0.0,
            squares: 0.0,
        };
        allocation.expect(&counts);
        let first = counts.iter().rposition(|count| *count > 0).unwrap_or(0);
        // One class after the other takes twice as many samples, and those above take more.
        for even in (0..=first).rev() {
            if allocation.error <= aim {
                break;
            }
            for (class, pairs) in allocation.pairs.iter_mut().enumerate().skip(even) {
                let doublings = (class - even).div_ceil(PER_DOUBLING).min(31) as u32;
                *pairs = least.saturating_mul(1 << doublings).min(most);
            }
            allocation.expect(&counts);
        }
        allocation
    }

    /// Adds up the expected errors.
    fn expect(&mut self, counts: &[u64]) {
        (self.error, self.squares) = (0.0, 0.0);
        for (class, count) in counts.iter().enumerate().filter(|(_, count)| **count > 0) {
            let samples = 2.0 * f64::from(self.pairs[class]);
            let error = 2.0 * doubt_of(class) / (samples * samples.sqrt());
            self.error += *count as f64 * error;
            self.squares += *count as f64 * error * error;
        }
    }

    /// The expected squared errors of the eight pixels that count most, about: so few may
    /// pass a check by luck.
    pub fn of_few(&self) -> f64 {
        const FEW: f64 = 8.0;
        if self.squares > 0.0 {
            self.error.min(FEW * self.squares / self.error)
        } else {
            0.0
        }
    }

    /// The pairs that a pixel of this doubt is to have.
    pub fn pairs(&self, doubt: f32) -> u32 {
        self.pairs[class(doubt)]
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

    /// Doubts of 1/1024 to 1, a thousand of each.
    fn doubts() -> Vec<f32> {
        let powers = (0..=10).map(|i| 1.0 / (1 << i) as f32);
        powers.flat_map(|doubt| [doubt; 1000]).collect()
    }

    fn error(doubts: &[f32], allocation: &Allocation) -> f64 {
        let error = |doubt: &f32| {
            let samples = f64::from(2 * allocation.pairs(*doubt));
            2.0 * f64::from(*doubt) / (samples * samples.sqrt())
        };
        doubts.iter().map(error).sum()
    }

    /// A class is an eighth wide on both sides of its middle.
    #[test]
    fn the_expected_error_comes_near_the_aim() {
        for aim in [1000.0, 100.0, 1.0, 0.01] {
            let doubts = doubts();
            let allocation = Allocation::new(&doubts, 1, 1 << 20, aim);
            let error = error(&doubts, &allocation);
            assert!(error < aim * 1.13 && error > aim / 2.0, "{error} of {aim}");
        }
    }

    #[test]
    fn samples_grow_with_the_power_two_fifths_of_the_doubt() {
        let allocation = Allocation::new(&doubts(), 1, 1 << 20, 1.0);
        let pairs = |doubt: f32| f64::from(allocation.pairs(doubt));
        assert_eq!(pairs(1.0), 4.0 * pairs(1.0 / 32.0));
        assert_eq!(pairs(1.0 / 32.0), 4.0 * pairs(1.0 / 1024.0));
    }

    #[test]
    fn pairs_stay_between_least_and_most() {
        let all = doubts();
        let enough = Allocation::new(&all, 3, 100, 1e9);
        assert!(all.iter().all(|doubt| enough.pairs(*doubt) == 3));
        let never = Allocation::new(&all, 3, 100, 1e-9);
        assert!(all.iter().all(|doubt| never.pairs(*doubt) == 100));
        assert_eq!(never.pairs(0.0), 3);
    }
}
