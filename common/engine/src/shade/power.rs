//! `powers`: four cosines, each raised to the exponent of a highlight.

use std::ops::MulAssign;

use crate::lanes::{Lanes, is_set};

/// Up to this exponent squaring loses at most 1e-13.
const LARGEST: f64 = 1024.0;

/// Four powers. Lanes that are not active hold anything.
#[inline]
pub(super) fn powers(bases: Lanes, exponents: [f64; 4], active: u32) -> Lanes {
    let [first, others @ ..] = exponents;
    if others.iter().all(|exponent| *exponent == first)
        && let Some(whole) = whole(first)
    {
        return squaring(bases, whole);
    }
    let bases = bases.to_array();
    Lanes::new([0, 1, 2, 3].map(|lane| {
        if is_set(active, lane) {
            power(bases[lane], exponents[lane])
        } else {
            0.0
        }
    }))
}

/// A power: by squaring where the exponent is a small whole number.
fn power(base: f64, exponent: f64) -> f64 {
    whole(exponent).map_or_else(|| libm::pow(base, exponent), |whole| squaring(base, whole))
}

/// The power of one number, or of four, to a whole exponent.
#[inline]
fn squaring<T: Copy + From<f64> + MulAssign>(mut base: T, mut exponent: u64) -> T {
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

/// The exponent, if it is a small whole number.
fn whole(exponent: f64) -> Option<u64> {
    let whole = exponent as u32;
    (exponent <= LARGEST && f64::from(whole) == exponent).then(|| whole.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_powers_are_exact() {
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

    /// The result is rounded after each product, unlike a power that is rounded once.
    #[test]
    fn a_small_whole_exponent_multiplies() {
        for base in (1..100_u32).map(|i| f64::from(i) / 100.0) {
            assert_eq!(power(base, 3.0), base * (base * base));
        }
    }

    #[test]
    fn four_powers_have_the_bits_of_single_ones() {
        let bases = [0.1, 0.9, 0.999, 1.0];
        for exponents in [[32.0; 4], [7.5; 4], [0.0; 4], [1.0, 2.0, 2.5, 1e9]] {
            let four = powers(Lanes::new(bases), exponents, 0b1111).to_array();
            assert_eq!(four, [0, 1, 2, 3].map(|i| power(bases[i], exponents[i])));
        }
    }

    /// Rounding of the base and rounding of the products may each lead to an error of
    /// `u P`, where u is half of epsilon.
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
