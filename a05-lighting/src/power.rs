//! `power`: a cosine, raised to the exponent of a highlight.

use std::ops::MulAssign;

use a02_math::Lanes;

/// `base` to the power of an `exponent` that is at least 0.
///
/// Small whole exponents are added up from powers of two, by squaring. That takes
/// fewer operations than [`libm::pow`], and rounding them moves the result by no
/// more than rounding the base did: by half of epsilon times the exponent.
pub(crate) fn power(base: f64, exponent: f64) -> f64 {
    whole(exponent).map_or_else(|| libm::pow(base, exponent), |whole| squaring(base, whole))
}

/// The power of any number, or of four, to a whole exponent.
#[inline]
pub(crate) fn squaring<T: Copy + From<f64> + MulAssign>(mut base: T, mut exponent: u64) -> T {
    let mut power = T::from(1.0);
    while exponent > 0 {
        if exponent & 1 != 0 {
            power *= base;
        }
        base *= base;
        exponent >>= 1;
    }
    power
}

/// Four powers. In lanes whose bit in `active` is not set they are anything.
#[inline]
pub(crate) fn powers(bases: Lanes, exponents: [f64; 4], active: u32) -> Lanes {
    let [first, others @ ..] = exponents;
    if others.iter().all(|exponent| *exponent == first)
        && let Some(whole) = whole(first)
    {
        return squaring(bases, whole);
    }
    let bases = bases.to_array();
    Lanes::new([0, 1, 2, 3].map(|lane| {
        let is_active = active >> lane & 1 != 0;
        if is_active {
            power(bases[lane], exponents[lane])
        } else {
            0.0
        }
    }))
}

/// Up to here squaring loses at most 1e-13, which nobody sees.
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

    /// Rounded after each product, which a power rounded once is not always.
    #[test]
    fn a_small_whole_exponent_multiplies() {
        for base in (1..100_u32).map(|i| f64::from(i) / 100.0) {
            assert_eq!(power(base, 3.0), base * (base * base));
        }
    }

    #[test]
    fn four_powers_are_those_of_one() {
        let bases = [0.1, 0.9, 0.999, 1.0];
        for exponents in [[32.0; 4], [7.5; 4], [0.0; 4], [1.0, 2.0, 2.5, 1e9]] {
            let four = powers(Lanes::new(bases), exponents, 0b1111).to_array();
            assert_eq!(four, [0, 1, 2, 3].map(|i| power(bases[i], exponents[i])));
        }
    }

    /// `u P` is what rounding the base and what rounding the products may do,
    /// each: u is half of epsilon.
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
