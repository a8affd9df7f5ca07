//! The interval of 95 % of a measured error.
//!
//! The inputs of an experiment are a sample of all inputs, so the error of another sample would
//! be another one. Two errors whose intervals overlap cannot be told apart.

/// The ends of an interval that holds the true value with 95 %.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The lower end.
    pub low: f64,
    /// The upper end.
    pub high: f64,
}

/// The groups of inputs that are drawn again.
const GROUPS: usize = 64;

/// The numbers of samples that are drawn, of which the outermost 2.5 % on each side are left out.
const DRAWN: usize = 400;
const OUTSIDE: usize = DRAWN / 40;

/// The squared errors of some inputs.
#[derive(Clone, Copy, Default)]
struct Group {
    sum: f64,
    count: f64,
}

/// The interval of the root mean square of errors, those of an input side by side, by the bootstrap
/// over inputs (B. Efron and R. J. Tibshirani, An Introduction to the Bootstrap, 1993, chapter 13).
/// Many inputs are drawn in random groups, which has the same variance.
pub(crate) fn of_rms(errors: &[f64], errors_per_input: usize) -> Interval {
    let mut groups = vec![Group::default(); GROUPS.min(errors.len() / errors_per_input)];
    if groups.is_empty() {
        return Interval {
            low: f64::NAN,
            high: f64::NAN,
        };
    }
    let count = groups.len();
    let are_many = count == GROUPS;
    for (n, input) in errors.chunks_exact(errors_per_input).enumerate() {
        let group = if are_many { random(n, 0, count) } else { n };
        groups[group].sum += input.iter().map(|error| error * error).sum::<f64>();
        groups[group].count += errors_per_input as f64;
    }
    let mut drawn = Vec::new();
    for sample in 0..DRAWN {
        let mut all = Group::default();
        for n in 0..count {
            let group = groups[random(n, 1 + sample, count)];
            all.sum += group.sum;
            all.count += group.count;
        }
        // A sample of empty groups says nothing.
        if all.count > 0.0 {
            drawn.push((all.sum / all.count).sqrt());
        }
    }
    drawn.sort_by(f64::total_cmp);
    Interval {
        low: drawn[OUTSIDE.min(drawn.len() - 1)],
        high: drawn[drawn.len().saturating_sub(1 + OUTSIDE)],
    }
}

/// The interval of a fraction of this number of decisions (E. B. Wilson, Probable Inference, the Law
/// of Succession, and Statistical Inference, 1927).
pub(crate) fn of_fraction(fraction: f64, decisions: usize) -> Interval {
    const Z: f64 = 1.96;
    let n = decisions as f64;
    let middle = fraction + Z * Z / (2.0 * n);
    let half = Z * (fraction * (1.0 - fraction) / n + Z * Z / (4.0 * n * n)).sqrt();
    let scale = 1.0 + Z * Z / n;
    Interval {
        low: ((middle - half) / scale).max(0.0),
        high: ((middle + half) / scale).min(1.0),
    }
}

/// A random number below `count`, the same in every run, by the finaliser of `SplitMix64` (G. L. Steele,
/// D. Lea and C. H. Flood, Fast Splittable Pseudorandom Number Generators, 2014).
fn random(n: usize, stream: usize, count: usize) -> usize {
    let mut z = (n as u64) ^ ((stream as u64) << 32);
    z = z.wrapping_add(1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    ((z ^ (z >> 31)) % count as u64) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Errors of equal size have no interval; those of 0 and 1, as often, have one of
    /// 1.96 times 0.5 / sqrt(n) around the mean square of 1/2.
    #[test]
    fn the_interval_is_that_of_the_mean_square() {
        let equal = vec![-0.5; 10_000];
        let of_equal = of_rms(&equal, 1);
        assert_eq!([of_equal.low, of_equal.high], [0.5; 2]);
        let mixed: Vec<_> = (0..10_000).map(|n| f64::from(n % 2)).collect();
        let Interval { low, high } = of_rms(&mixed, 1);
        let half = 1.96 * 0.5 / 100.0;
        for (end, exact) in [(low, 0.5 - half), (high, 0.5 + half)] {
            assert!((end * end - exact).abs() < 0.25 * half, "{low} {high}");
        }
        // If all errors come in equal fours, there are a quarter as many inputs.
        let fours: Vec<_> = (0..10_000).map(|n| f64::from(n / 4 % 2)).collect();
        let of_fours = of_rms(&fours, 4);
        assert!(of_fours.high - of_fours.low > 1.6 * (high - low));
        assert!(of_rms(&[], 1).low.is_nan());
    }

    /// Of 100 decisions, none wrong: at most z² / (n + z²), and as much missing from 1 for all.
    #[test]
    fn the_interval_of_a_fraction_is_that_of_wilson() {
        let none = of_fraction(0.0, 100);
        let most = 1.96 * 1.96 / (100.0 + 1.96 * 1.96);
        assert!(none.low == 0.0 && (none.high - most).abs() < 1e-12);
        let all = of_fraction(1.0, 100);
        assert!(all.high > 1.0 - 1e-12 && (all.low - 1.0 + most).abs() < 1e-12);
    }
}
