//! The radical inverse: numbers that fill the way from 0 to 1 evenly.

use crate::prelude::*;

/// The digits of `n` in a `base` of at least 2, mirrored at the point: 6 is 110
/// in base 2, and becomes 0.011, which is 3/8.
pub fn radical_inverse(mut n: u32, base: u32) -> f64 {
    let (mut digits, mut scale) = (0.0, 1.0);
    while n > 0 {
        digits = digits * f64::from(base) + f64::from(n % base);
        scale *= f64::from(base);
        n /= base;
    }
    digits / scale
}

testing::examples! {
    assert_eq!([0, 1, 2, 3].map(|n| radical_inverse(n, 2)), [0.0, 0.5, 0.25, 0.75]);
    assert_eq!(radical_inverse(6, 2), 0.375);
    assert_close(radical_inverse(5, 3), 7.0 / 9.0);
    assert_close(radical_inverse(1234, 10), 0.4321);
}
