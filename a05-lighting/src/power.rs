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
#[must_use]
pub const fn squaring(mut base: f64, mut exponent: u64) -> f64 {
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
const MAX_EXPONENT: f64 = 1024.0;

/// The exponent, if it is a small whole number.
fn whole(exponent: f64) -> Option<u64> {
    let whole = exponent as u32;
    (exponent <= MAX_EXPONENT && f64::from(whole) == exponent).then(|| whole.into())
}
