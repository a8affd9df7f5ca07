//! Times with their noise: medians, and intervals that hold the true ones.

use std::fmt;

/// The median of repeated measurements, and the interval that holds the median of all
/// measurements there could be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Median {
    /// The lower end of the interval.
    pub low: f64,
    /// The median.
    pub value: f64,
    /// The upper end of the interval.
    pub high: f64,
}

impl Median {
    /// The fewest measurements whose interval holds with 95 %.
    pub const ROUNDS: usize = 6;

    /// The median of some measurements. Each of them is above the true median with the
    /// probability 1/2, so that the number of those below it is binomial: the interval
    /// between the k-th of them from below and from above holds it with 95 % or more, for
    /// the largest such k (H. A. David and H. N. Nagaraja, Order Statistics, 2003,
    /// section 7.1). Of less than six measurements it has all.
    pub fn of(mut measured: Vec<f64>) -> Self {
        measured.sort_by(f64::total_cmp);
        let count = measured.len();
        let (mut outside, mut term, mut k) = (0.0, libm::pow(0.5, count as f64), 0);
        while 2.0 * (outside + term) <= 0.05 {
            outside += term;
            term *= (count - k) as f64 / (k + 1) as f64;
            k += 1;
        }
        let at = |i: usize| measured.get(i).copied().unwrap_or(f64::NAN);
        let k = k.max(1);
        Self {
            low: at(k - 1),
            value: f64::midpoint(at(count.saturating_sub(1) / 2), at(count / 2)),
            high: at(count.saturating_sub(k)),
        }
    }

    /// The median of the quotients of measurements that were taken by turns.
    #[must_use]
    pub fn of_quotients(dividends: &[f64], divisors: &[f64]) -> Self {
        let pairs = dividends.iter().zip(divisors);
        Self::of(pairs.map(|(a, b)| a / b).collect())
    }

    /// The noise in words if a quotient does not differ from 1 beyond it.
    #[must_use]
    pub fn noise(&self) -> Option<String> {
        let factor = self.high.max(1.0 / self.low);
        let is_noise = self.low <= 1.0 && self.high >= 1.0;
        is_noise.then(|| match factor {
            ..2.0 => format!("{:.0} %", (100.0 * (factor - 1.0)).ceil()),
            _ => format!("a factor of {factor:.1}"),
        })
    }
}

/// A quotient with its interval; within noise, only the noise.
impl fmt::Display for Median {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { low, value, high } = self;
        match self.noise() {
            Some(noise) => write!(f, "no difference beyond {noise}"),
            None => write!(f, "{value:.2} ({low:.2}-{high:.2})"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of 6 measurements all are on one side of the median once in 32 times; of 15, at
    /// most three are on one side in 1152 of 32768 (sums of binomial coefficients).
    #[test]
    fn the_interval_holds_the_median_with_95_percent() {
        let of = |count: i32| Median::of((1..=count).rev().map(f64::from).collect());
        let interval = |low, value, high| Median { low, value, high };
        assert_eq!(of(3), interval(1.0, 2.0, 3.0));
        assert_eq!(of(6), interval(1.0, 3.5, 6.0));
        assert_eq!(of(9), interval(2.0, 5.0, 8.0));
        assert_eq!(of(15), interval(4.0, 8.0, 12.0));
    }

    #[test]
    fn quotients_within_noise_are_said_to_be_equal() {
        let quotient = |dividends: [f64; 3]| Median::of_quotients(&dividends, &[1.0, 2.0, 4.0]);
        for (dividends, text) in [
            ([0.8, 2.1, 4.2], "no difference beyond 25 %"),
            ([0.4, 2.1, 4.2], "no difference beyond a factor of 2.5"),
            ([2.0, 5.0, 8.0], "2.00 (2.00-2.50)"),
        ] {
            assert_eq!(quotient(dividends).to_string(), text);
        }
    }
}
