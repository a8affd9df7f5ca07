//! The radical inverse: numbers that fill the way from 0 to 1 evenly.

/// The digits of `n` in a `base` of at least 2, mirrored at the point: 6 is 110
/// in base 2, and becomes 0.011, which is 3/8.
pub fn radical_inverse(mut n: u32, base: u32) -> f64 {
    // Whole numbers, and one division: it rounds once.
    let (mut mirrored, mut scale) = (0_u64, 1_u64);
    while n > 0 {
        mirrored = mirrored * u64::from(base) + u64::from(n % base);
        scale *= u64::from(base);
        n /= base;
    }
    mirrored as f64 / scale as f64
}
