//! `NestedSamples`: places in a pixel that are evenly spread at every number
//! of them, so that more can be added when the first turn out to be too few.
//!
//! A stratified grid must be thrown away for a finer one. Here the first 4
//! places lie in the 4 quarters of the pixel, the first 16 in its 16
//! sixteenths, and so on: the same cells, filled one after the other.

use crate::PixelRandom;

/// An endless row of places. Of any first 2^k, one lies in each box of the
/// pixel that is 2^-i wide and 2^(i-k) high: they are a (0, 2)-sequence, that
/// of Sobol' (1967), scrambled as Owen (1995) does and Burley (Practical
/// Hash-based Owen Scrambling, 2020) computes it.
#[derive(Clone, Copy, Debug)]
pub struct NestedSamples {
    seeds: [u32; 2],
}

impl NestedSamples {
    /// Places that do not depend on those of another `set` of the same pixel.
    #[must_use]
    pub fn new(random: &PixelRandom, set: u64) -> Self {
        let seed = |n| (random.uniform(2 * set + n) * TWO_32) as u32;
        Self {
            seeds: [seed(0), seed(1)],
        }
    }

    /// The place of this index: from the pixel's upper left corner, each
    /// coordinate at least 0 and less than 1.
    #[must_use]
    pub fn place(&self, index: u32) -> (f64, f64) {
        let scrambled =
            |digits: u32, seed| f64::from(scramble(digits, seed).reverse_bits()) / TWO_32;
        let [x, y] = self.seeds;
        (scrambled(index, x), scrambled(second(index), y))
    }
}

const TWO_32: f64 = 4_294_967_296.0;

/// The second coordinate of the sequence of Sobol', as the first one is the
/// index itself: lowest digit first.
const fn second(mut index: u32) -> u32 {
    let (mut digits, mut column) = (0, 1_u32);
    while index != 0 {
        if index & 1 == 1 {
            digits ^= column;
        }
        column ^= column << 1;
        index >>= 1;
    }
    digits
}

/// Flips each digit, depending on the lower ones and the seed: an even factor
/// carries nothing downwards. The factors are those of Burley, section 3.
const fn scramble(mut digits: u32, seed: u32) -> u32 {
    digits = digits.wrapping_add(seed);
    digits ^= digits.wrapping_mul(0x6C50_B47C);
    digits ^= digits.wrapping_mul(0xB82F_1E52);
    digits ^= digits.wrapping_mul(0xC7AF_E638);
    digits ^ digits.wrapping_mul(0x8D22_F6E6)
}
