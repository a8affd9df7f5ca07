//! The radical inverse: numbers that fill the way from 0 to 1 evenly.

/// The digits of `n` in a `base` of at least 2, mirrored at the point: 6 is 110
/// in base 2, and becomes 0.011, which is 3/8.
pub fn radical_inverse(mut n: u32, base: u32) -> f64 {
    testing::missing("the mirrored digits", 0.5)
}
