//! `Allocation`: the number of samples of each pixel.
//!
//! Where an edge crosses a pixel, its squared error is about `2 V n^(-3/2)`: `V` is the
//! variance of a sample and `n` the number of samples, of which only some √n lie next to the
//! edge (Mitchell, Consequences of Stratified Sampling in Graphics, 1996). For a given sum of
//! these errors, the sum of all `n` is least if `n` grows as `V^(2/5)`: then one more sample
//! gains equally much everywhere.

use rayon::iter::ParallelIterator;
use rayon::slice::ParallelSlice;

/// A class of variances has one exponent and one pair of leading binary digits.
const DIGITS: u32 = f32::MANTISSA_DIGITS - 1 - 2;
const CLASSES: usize = 1 << (31 - DIGITS);
/// Classes of twice as many samples: `V` grows by 2^(5/2).
const PER_DOUBLING: usize = 10;

fn class(variance: f32) -> usize {
    (variance.to_bits() >> DIGITS) as usize % CLASSES
}

/// The variance in the middle of a class.
fn variance_of(class: usize) -> f64 {
    f32::from_bits((class as u32) << DIGITS | 1 << (DIGITS - 1)).into()
}

/// The target of an allocation.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// Bounds of the number of pairs of a pixel.
    pub min_pairs: u32,
    pub max_pairs: u32,
    /// Upper bound of the sum of the expected squared errors.
    pub error: f64,
    /// Samples beyond the least number that make the error smaller than that.
    pub spare_samples: f64,
}

/// Spare samples lower the error at most to this part of the target.
const MIN_ERROR: f64 = 1.0 / 16.0;

/// The pairs of samples for each class of variances.
pub struct Allocation {
    target: Target,
    /// The first class with twice as many samples as the least. All below have the least.
    first: usize,
}

impl Allocation {
    /// The allocation for these expected variances that reaches the target, if one does.
    pub fn new(variances: &[f32], target: Target) -> Self {
        let counts = counts(variances);
        let expect = |first| Self { target, first }.expect(&counts);
        // With each smaller `first` the error falls, and the number of samples grows.
        let is_too_little = |first: usize| {
            let (error, _) = expect(first);
            let (_, samples) = expect(first - 1);
            error > target.error
                || (samples <= target.spare_samples && error > MIN_ERROR * target.error)
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
            target,
            first: enough,
        }
    }

    /// The sum of the expected squared errors, and the number of samples beyond the least.
    fn expect(&self, counts: &[u64]) -> (f64, f64) {
        let (mut error, mut additional) = (0.0, 0.0);
        for (class, count) in counts.iter().enumerate().filter(|(_, count)| **count > 0) {
            let (pairs, count) = (self.pairs_of(class), *count as f64);
            let samples = 2.0 * f64::from(pairs);
            error += count * 2.0 * variance_of(class) / (samples * samples.sqrt());
            additional += count * 2.0 * f64::from(pairs - self.target.min_pairs);
        }
        (error, additional)
    }

    fn pairs_of(&self, class: usize) -> u32 {
        let Target {
            min_pairs,
            max_pairs,
            ..
        } = self.target;
        let above = (class + 1).saturating_sub(self.first);
        let doublings = above.div_ceil(PER_DOUBLING).min(31) as u32;
        let pairs = min_pairs.saturating_mul(1 << doublings);
        pairs.min(max_pairs).max(min_pairs)
    }

    /// The pairs of a pixel with this expected variance.
    pub fn pairs(&self, variance: f32) -> u32 {
        self.pairs_of(class(variance))
    }
}

/// The number of pixels of each class, without those of no variance.
fn counts(variances: &[f32]) -> Vec<u64> {
    let count = |variances: &[f32]| {
        let mut counts = vec![0; CLASSES];
        for variance in variances.iter().filter(|variance| **variance > 0.0) {
            counts[class(*variance)] += 1;
        }
        counts
    };
    let add = |a: Vec<u64>, b: Vec<u64>| a.iter().zip(&b).map(|(a, b)| a + b).collect();
    let parts = variances.par_chunks(1 << 14).map(count);
    parts.reduce(|| vec![0; CLASSES], add)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Variances of 1/1024 to 1, a thousand of each; the expected error, and the most pairs.
    fn result(max_pairs: u32, error: f64, spare_samples: f64) -> (f64, u32) {
        let target = Target {
            min_pairs: 3,
            max_pairs,
            error,
            spare_samples,
        };
        let powers = (0..=10).map(|i| 1.0 / (1 << i) as f32);
        let variances: Vec<_> = powers.flat_map(|variance| [variance; 1000]).collect();
        let allocation = Allocation::new(&variances, target);
        assert_eq!(allocation.pairs(0.0), 3);
        let error = |variance: &f32| {
            let samples = f64::from(2 * allocation.pairs(*variance));
            2.0 * f64::from(*variance) / (samples * samples.sqrt())
        };
        (variances.iter().map(error).sum(), allocation.pairs(1.0))
    }

    /// A class is an eighth wide on both sides of its middle.
    #[test]
    fn the_expected_error_is_close_to_the_target() {
        for target in [100.0, 1.0, 0.01] {
            let (error, _) = result(1 << 20, target, 0.0);
            let is_close = error < target * 1.13 && error > target / 2.0;
            assert!(is_close, "{error} of {target}");
            let (smaller, _) = result(1 << 20, target, 1e9);
            assert!(smaller < target / 12.0, "{smaller} of {target}");
        }
        assert_eq!(result(100, 1e9, 0.0).1, 3);
        assert_eq!(result(100, 1e-9, 0.0).1, 100);
    }
}
