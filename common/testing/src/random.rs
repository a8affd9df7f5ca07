//! `Random`: the random inputs of tests and checks, the same in every run.

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

use common::Color;
use rand::rngs::ChaCha20Rng;
use rand::{RngExt, SeedableRng};

/// Calls a test with the random numbers of each of the first seeds. If it panics, the seed is printed.
pub fn for_seeds(count: u64, test: impl Fn(&mut Random)) {
    for seed in 0..count {
        let tested = catch_unwind(AssertUnwindSafe(|| test(&mut Random::new(seed))));
        if let Err(panic) = tested {
            eprintln!("with the seed {seed}");
            resume_unwind(panic);
        }
    }
}

/// A source of random numbers, which a seed determines.
pub struct Random(ChaCha20Rng);

impl Random {
    /// The numbers of this seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        let mut bytes = [0; 32];
        bytes[..8].copy_from_slice(&seed.to_le_bytes());
        Self(ChaCha20Rng::from_seed(bytes))
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

    /// A colour whose channels are from 0 to 1.5.
    pub fn color(&mut self) -> Color {
        let [r, g, b] = [(); 3].map(|()| self.between(0.0, 1.5));
        Color::new(r, g, b)
    }

    /// A power of ten, from 1e-12 to 1e12: the length of a direction.
    pub fn scale(&mut self) -> f64 {
        [1e-12, 1e-6, 1e-3, 0.1, 1.0, 10.0, 1e3, 1e6, 1e12][self.below(9) as usize]
    }
}
