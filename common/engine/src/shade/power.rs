//! `powers`: four cosines, each raised to the exponent of a highlight.

use std::ops::MulAssign;

use crate::lanes::{Lanes, Simd, is_set, lanes, splat};

/// Up to this exponent squaring loses at most 1e-13.
const MAX_EXPONENT: f64 = 1024.0;

/// Four powers. Lanes that are not active hold anything.
#[inline(always)]
pub(super) fn powers<S: Simd>(bases: Lanes<S>, exponents: [f64; 4], active: u32) -> Lanes<S> {
    let [first, others @ ..] = exponents;
    if others.iter().all(|exponent| *exponent == first)
        && let Some(whole) = whole(first)
    {
        return squaring(bases, splat(bases.simd, 1.0), whole);
    }
    let powers = [0, 1, 2, 3].map(|lane| {
        if is_set(active, lane) {
            power(bases[lane], exponents[lane])
        } else {
            0.0
        }
    });
    lanes(bases.simd, powers)
}

/// A power: by squaring where the exponent is a small whole number.
fn power(base: f64, exponent: f64) -> f64 {
    whole(exponent).map_or_else(
        || libm::pow(base, exponent),
        |whole| squaring(base, 1.0, whole),
    )
}

/// The power of one number, or of four, to a whole exponent, times `power`.
#[inline(always)]
fn squaring<T: Copy + MulAssign>(mut base: T, mut power: T, mut exponent: u64) -> T {
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
    (exponent <= MAX_EXPONENT && f64::from(whole) == exponent).then(|| whole.into())
}
