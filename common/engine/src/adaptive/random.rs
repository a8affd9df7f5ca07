//! `PixelRandom`: random numbers that belong to a pixel.
//!
//! With one generator for all pixels, the picture would depend on the order in which threads
//! render the pixels. Here the n-th number of a pixel is a hash of the seed, the pixel and n.

/// The random numbers of one pixel.
#[derive(Clone, Copy, Debug)]
pub struct PixelRandom {
    key: u64,
}

impl PixelRandom {
    /// The random numbers of the pixel in column `x` and row `y`, for this `seed`.
    #[must_use]
    pub const fn new(seed: u64, x: u32, y: u32) -> Self {
        let pixel = (y as u64) << 32 | x as u64;
        Self {
            key: mix(mix(seed.wrapping_add(GOLDEN)) ^ pixel),
        }
    }

    /// The `n`-th number: evenly distributed, at least 0 and less than 1.
    #[must_use]
    pub const fn uniform(self, n: u64) -> f64 {
        let bits = mix(self
            .key
            .wrapping_add(n.wrapping_add(1).wrapping_mul(GOLDEN)));
        // A double has 53 binary digits; with more, some numbers would round to 1.
        (bits >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// 2^64 divided by the golden ratio: its multiples modulo 2^64 are spread evenly.
const GOLDEN: u64 = 0x9E37_79B9_7F4A_7C15;

/// The output function of `SplitMix64` (Steele, Lea, Flood: Fast Splittable
/// Pseudorandom Number Generators, 2014), with the constants of Stafford's
/// variant 13: every bit of the input changes about half of the output.
const fn mix(mut bits: u64) -> u64 {
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    bits ^ (bits >> 31)
}
