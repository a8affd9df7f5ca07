//! `Sampler`: the positions of the samples in a pixel.

use common::{Sampling, Settings};

use crate::PixelRandom;

/// Places the samples of every pixel.
#[derive(Clone, Copy, Debug)]
pub struct Sampler {
    pub(crate) sampling: Sampling,
    /// Number of grid cells in each direction, for samplings on a grid.
    cells: u32,
    samples: u32,
    seed: u64,
}

impl Sampler {
    /// A sampler with the number of samples in the settings, and at least one.
    /// Samplings on a grid round it down to a square number.
    #[must_use]
    pub fn new(settings: &Settings) -> Self {
        let wanted = settings.samples.max(1);
        let cells = wanted.isqrt();
        Self {
            sampling: settings.sampling,
            cells,
            samples: match settings.sampling {
                Sampling::Center => 1,
                Sampling::Random => wanted,
                Sampling::Regular | Sampling::Stratified => cells * cells,
            },
            seed: settings.seed,
        }
    }

    /// Number of samples in a pixel: at least one.
    #[must_use]
    pub const fn samples(&self) -> u32 {
        self.samples
    }

    /// The positions of the samples in the pixel in column `x` and row `y`.
    pub fn places(self, x: u32, y: u32) -> impl Iterator<Item = (f64, f64)> {
        (0..self.samples).map(move |i| self.place(i, x, y))
    }

    /// The position of sample `i`, counted from 0, in the pixel in column `x` and row
    /// `y`: from its upper left corner, rightwards and downwards, each at least 0
    /// and less than 1.
    #[must_use]
    pub fn place(&self, i: u32, x: u32, y: u32) -> (f64, f64) {
        // ANCHOR: cells
        let cell = |(dx, dy): (f64, f64)| {
            let (column, row) = (f64::from(i % self.cells), f64::from(i / self.cells));
            let cells = f64::from(self.cells);
            ((column + dx) / cells, (row + dy) / cells)
        };
        match self.sampling {
            Sampling::Center => (0.5, 0.5),
            Sampling::Regular => cell((0.5, 0.5)),
            Sampling::Random => self.jitter(i, x, y),
            Sampling::Stratified => cell(self.jitter(i, x, y)),
        }
        // ANCHOR_END: cells
    }

    /// Two random numbers for sample `i` of a pixel.
    fn jitter(&self, i: u32, x: u32, y: u32) -> (f64, f64) {
        let random = PixelRandom::new(self.seed, x, y);
        let first = 2 * u64::from(i);
        (random.uniform(first), random.uniform(first + 1))
    }
}
