//! Random numbers and directions that are the same in every run.

use a02_math::Vector3;
use a03_rays_cameras::PixelRandom;

/// A generator of random numbers.
pub struct Numbers {
    random: PixelRandom,
    drawn: u64,
}

impl Numbers {
    /// The numbers of the `n`-th ray or other object.
    pub const fn new(seed: u64, n: usize) -> Self {
        Self {
            random: PixelRandom::new(seed, n as u32, 0),
            drawn: 0,
        }
    }

    /// The next number of an interval.
    pub fn between(&mut self, least: f64, most: f64) -> f64 {
        self.drawn += 1;
        least + (most - least) * self.random.uniform(self.drawn - 1)
    }

    /// The next whole number below `count`.
    pub fn below(&mut self, count: usize) -> usize {
        self.between(0.0, count as f64) as usize
    }

    pub fn triple(&mut self, least: f64, most: f64) -> Vector3 {
        let [x, y, z] = std::array::from_fn(|_| self.between(least, most));
        Vector3::new(x, y, z)
    }

    pub fn direction(&mut self) -> Vector3 {
        loop {
            let inside = self.triple(-1.0, 1.0);
            if (0.01..=1.0).contains(&inside.magnitude()) {
                return inside * (1.0 / inside.magnitude());
            }
        }
    }

    /// Two vectors of length 1, perpendicular up to rounding.
    pub fn perpendicular(&mut self) -> [Vector3; 2] {
        let first = self.direction();
        loop {
            if let Some(second) = first.cross(self.direction()).normalized() {
                return [first, second];
            }
        }
    }
}
