//! `Sequence`: the positions of a pixel's samples.
//!
//! They are the points of Sobol's sequence: of the first 2^k, each of 2^k equal strips of
//! the pixel has one, upright or level, and so has each rectangle of that area that halving
//! leads to. An edge is uncertain only in the few that it crosses. Owen's scrambling swaps
//! halves, and halves of halves, at random: every position is equally likely, and every mean
//! right on average.
//!
//! Here both halves of a coordinate are scrambled alike, one as the mirror image of the
//! other. So samples come in pairs, a position and its mirror image at the pixel's middle, and
//! light that changes evenly has its exact mean in each pair.
//!
//! (Owen: Randomly Permuted (t,m,s)-Nets and (t,s)-Sequences, 1995. Burley: Practical
//! Hash-based Owen Scrambling, JCGT 9(4), 2020, with the hash of Laine and Karras as
//! N. Vegdahl improved it.)

use super::random::PixelRandom;

/// The positions of the samples of a pixel, without end.
pub struct Sequence {
    seeds: [u32; 2],
}

impl Sequence {
    /// The sequence that the random numbers of a pixel select.
    pub fn new(random: PixelRandom) -> Self {
        let seed = |n| (random.uniform(n) * TWO_TO_32) as u32;
        Self {
            seeds: [seed(0), seed(1)],
        }
    }

    /// The positions of a pair in the pixel, each above 0 and below 1.
    pub fn pair(&self, i: u32) -> [(f64, f64); 2] {
        let x = mirrored(2 * i, self.seeds[0]);
        let y = mirrored(second(2 * i), self.seeds[1]);
        [(inside(x), inside(y)), (inside(!x), inside(!y))]
    }
}

const TWO_TO_32: f64 = 4_294_967_296.0;

fn inside(digits: u32) -> f64 {
    (f64::from(digits) + 0.5) / TWO_TO_32
}

/// The second coordinate of Sobol's point, its binary digits in reverse order. (The first
/// has those of `i`.)
const fn second(i: u32) -> u32 {
    let (mut digits, mut bit, mut left) = (0, 1_u32 << 31, i);
    while left > 0 {
        if left & 1 == 1 {
            digits ^= bit;
        }
        bit ^= bit >> 1;
        left >>= 1;
    }
    digits.reverse_bits()
}

/// A coordinate whose digits are given in reverse order, scrambled: each digit is swapped or
/// not, as the digits before it and the seed decide.
const fn scrambled(reversed: u32, seed: u32) -> u32 {
    let mut x = reversed;
    x ^= x.wrapping_mul(0x3d20_adea);
    x = x.wrapping_add(seed);
    x = x.wrapping_mul((seed >> 16) | 1);
    x ^= x.wrapping_mul(0x0552_6c56);
    x ^= x.wrapping_mul(0x53a2_2864);
    x.reverse_bits()
}

/// A coordinate scrambled so that its mirror image is scrambled alike. The mirror image of a
/// point of the sequence is the next one, whose coordinates differ in the first digit.
const fn mirrored(reversed: u32, seed: u32) -> u32 {
    if reversed & 1 == 1 {
        !scrambled(reversed ^ 1, seed)
    } else {
        scrambled(reversed, seed)
    }
}
