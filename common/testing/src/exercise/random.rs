//! `Random`: the random parameters of checks, the same in every run.

use proptest::prelude::RngExt;
use proptest::test_runner::{RngAlgorithm, TestRng};

/// A hundred random inputs, the same in every run.
pub fn random<I>(mut input: impl FnMut(&mut Random) -> I) -> impl Iterator<Item = I> {
    let mut random = Random::new(1);
    (0..100).map(move |_| input(&mut random))
}

/// A source of random numbers, which a seed determines.
#[derive(Clone, Debug)]
pub struct Random(TestRng);

impl Random {
    /// The numbers of this seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        let seed = [seed, 0, 0, 0].map(u64::to_le_bytes).concat();
        Self(TestRng::from_seed(RngAlgorithm::ChaCha, &seed))
    }

    /// A whole number, at least 0 and less than `end`, which is at least 1.
    pub fn below(&mut self, end: u32) -> u32 {
        self.0.random_range(..end)
    }

    /// A number from `start` to `end` in steps of a hundredth, so that the messages
    /// that contain it are short.
    pub fn between(&mut self, start: f64, end: f64) -> f64 {
        let hundredths = ((end - start) * 100.0).round() as u32;
        ((start * 100.0).round() + f64::from(self.below(hundredths + 1))) / 100.0
    }

    /// Three numbers from `-most` to `most` in steps of a hundredth.
    pub fn triple(&mut self, most: f64) -> [f64; 3] {
        [(); 3].map(|()| self.between(-most, most))
    }

    /// A power of ten from 1e-6 to 1e6: a length.
    pub fn scale(&mut self) -> f64 {
        10.0_f64.powi(self.below(13) as i32 - 6)
    }

    /// The coordinates of a direction, which are fractions. Its length is 1 by Lebesgue's
    /// identity `(m² + n² - p²)² + (2 m p)² + (2 n p)² = (m² + n² + p²)²`.
    pub fn unit(&mut self) -> [f64; 3] {
        let [m, n, p] = [(); 3].map(|()| f64::from(self.below(9)) - 4.5);
        let [x, y, z] = [2.0 * m * p, m * m + n * n - p * p, 2.0 * n * p];
        [x, y, z].map(|coordinate| coordinate / (m * m + n * n + p * p))
    }

    /// Three directions of length 1, perpendicular to each other, which form a right-handed
    /// system.
    pub fn frame(&mut self) -> [[f64; 3]; 3] {
        let (a, b) = (self.unit(), self.unit());
        let cross = |[ax, ay, az]: [f64; 3], [bx, by, bz]: [f64; 3]| {
            [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
        };
        let c = cross(a, b);
        let length = c.iter().map(|x| x * x).sum::<f64>().sqrt();
        if length < 0.1 {
            return self.frame();
        }
        let c = c.map(|coordinate| coordinate / length);
        [a, cross(c, a), c]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_their_range_and_fill_it() {
        let mut random = Random::new(1);
        let drawn: Vec<_> = (0..1000).map(|_| random.between(-0.02, 0.01)).collect();
        for exact in [-0.02, -0.01, 0.0, 0.01] {
            assert!(drawn.contains(&exact), "{exact}");
        }
        assert!(drawn.iter().all(|n| (-0.02..=0.01).contains(n)));
        for [x, y, z] in (0..1000).map(|_| random.unit()) {
            assert!((x * x + y * y + z * z - 1.0).abs() < 1e-15);
        }
    }
}
