//! `Random`: the random parameters of checks, the same in every run.

/// A source of random numbers, which a seed determines.
#[derive(Clone, Debug)]
pub struct Random {
    state: u64,
}

impl Random {
    /// The numbers of this seed.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self { state: seed }
    }

    /// A whole number, at least 0 and less than `end`, which is at least 1.
    pub fn below(&mut self, end: u32) -> u32 {
        (((self.bits() >> 32) * u64::from(end)) >> 32) as u32
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

    /// `SplitMix64` (Steele, Lea, Flood: Fast Splittable Pseudorandom Number
    /// Generators, 2014).
    fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut bits = self.state;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        bits ^ (bits >> 31)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first outputs for the seed 0 are published with the reference
    /// implementation by Vigna.
    #[test]
    fn the_numbers_are_those_of_the_reference() {
        let mut random = Random::new(0);
        assert_eq!(random.bits(), 0xE220_A839_7B1D_CDAF);
        assert_eq!(random.bits(), 0x6E78_9E6A_A1B9_65F4);
    }

    #[test]
    fn numbers_keep_their_range_and_fill_it() {
        let mut random = Random::new(1);
        let drawn: Vec<_> = (0..1000).map(|_| random.below(3)).collect();
        assert!((0..3).all(|n| drawn.contains(&n)) && drawn.iter().all(|&n| n < 3));
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
