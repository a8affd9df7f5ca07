//! The t distribution, by W. S. Gosset, called Student: how much wider an interval of 95 % is that comes from few points.

/// The factors for 1 to 10 degrees of freedom (M. Abramowitz and I. A. Stegun, Handbook of
/// Mathematical Functions, 1964, table 26.10).
const FEW: [f64; 10] = [
    12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228,
];

/// The factor of the normal distribution.
const Z: f64 = 1.96;

/// The number of standard errors on each side of an interval of 95 %, for this many points more than a
/// formula has numbers; with none, nothing is known. Beyond the table by the expansion 26.7.5 of the same
/// book, to three digits.
pub fn factor(degrees_of_freedom: usize) -> f64 {
    if degrees_of_freedom == 0 {
        return f64::INFINITY;
    }
    if let Some(factor) = FEW.get(degrees_of_freedom - 1) {
        return *factor;
    }
    let n = degrees_of_freedom as f64;
    let cube = Z * Z * Z;
    let first = (cube + Z) / 4.0;
    let second = (5.0 * cube * Z * Z + 16.0 * cube + 3.0 * Z) / 96.0;
    Z + first / n + second / (n * n)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of 12, 20 and 120 degrees of freedom, by the table: 2.179, 2.086, 1.980.
    #[test]
    fn the_factors_are_those_of_the_table() {
        for (n, expected) in [
            (1, 12.706),
            (2, 4.303),
            (12, 2.179),
            (20, 2.086),
            (120, 1.98),
        ] {
            assert!((factor(n) - expected).abs() < 2e-3, "{n}: {}", factor(n));
        }
        assert!(factor(0).is_infinite());
    }
}
