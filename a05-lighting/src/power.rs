//! `power`: a cosine, raised to the exponent of a highlight.

/// `base` to the power of an `exponent` that is at least 0.
///
/// Small whole exponents use exponentiation by squaring. That takes fewer
/// operations than [`libm::pow`], and its rounding error is no larger than the
/// effect of rounding the base: half of epsilon times the exponent.
pub(crate) fn power(base: f64, exponent: f64) -> f64 {
    whole(exponent).map_or_else(|| libm::pow(base, exponent), |whole| squaring(base, whole))
}

/// `base` to the power of a whole exponent.
pub(crate) fn squaring(mut base: f64, mut exponent: u64) -> f64 {
    let mut power = 1.0;
    while exponent > 0 {
        if exponent & 1 != 0 {
            power *= base;
        }
        base *= base;
        exponent >>= 1;
    }
    power
}

/// Largest exponent for squaring: the error is at most 1e-13, which is invisible.
const LARGEST: f64 = 1024.0;

/// The exponent, if it is a small whole number.
fn whole(exponent: f64) -> Option<u64> {
    let whole = exponent as u32;
    (exponent <= LARGEST && f64::from(whole) == exponent).then(|| whole.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_can_be_computed_exactly_is() {
        assert_eq!(power(0.5, 63.0), 1.0 / (1_u64 << 63) as f64);
        assert_eq!(power(0.75, 5.0), 243.0 / 1024.0);
        assert_eq!(power(0.25, 2.5), 1.0 / 32.0, "not a whole exponent");
        assert_eq!(power(0.3, 1.0), 0.3);
        assert_eq!(power(0.0, 0.0), 1.0);
        assert_eq!(power(0.0, 3.0), 0.0);
        assert_eq!(power(1.0, LARGEST), 1.0);
        assert_eq!(power(1.0, 1e300), 1.0);
        assert_eq!(power(0.5, 1e300), 0.0);
    }

    /// Squaring rounds after each product, so some results differ from `pow`.
    #[test]
    fn a_small_whole_exponent_multiplies() {
        for base in (1..100_u32).map(|i| f64::from(i) / 100.0) {
            assert_eq!(power(base, 3.0), base * (base * base));
        }
    }

    /// The error bounds of rounding the base and of rounding the products are `u P`
    /// each; u is half of epsilon.
    #[test]
    fn squaring_loses_no_more_than_the_base_has_lost() {
        for exponent in [2.0, 3.0, 64.0, 1000.0, LARGEST] {
            let base = 1.0 - 0.7 / exponent;
            let exact = libm::pow(base, exponent);
            let bound = exponent * f64::EPSILON;
            assert!(
                (power(base, exponent) / exact - 1.0).abs() <= bound,
                "{exponent}"
            );
        }
    }
}
