//! The samples of a pixel, placed as the settings say.

use common::{Sampling, Settings};
use engine::Sampler;

use crate::random::PixelRandom;

pub struct Samples {
    sampling: Sampling,
    /// Cells in each direction of the grid, for the samplings that have one.
    cells: u32,
    count: u32,
    seed: u64,
}

impl Samples {
    pub fn new(settings: &Settings) -> Self {
        let samples = settings.samples.max(1);
        let cells = samples.isqrt();
        Self {
            sampling: settings.sampling,
            cells,
            count: match settings.sampling {
                Sampling::Center => 1,
                Sampling::Random => samples,
                Sampling::Regular | Sampling::Stratified => cells * cells,
            },
            seed: settings.seed,
        }
    }

    /// Not inlined, so that samples in the middle of a pixel do not pay for it.
    #[inline(never)]
    fn jitter(&self, i: u32, column: u32, row: u32) -> (f64, f64) {
        let random = PixelRandom::new(self.seed, column, row);
        let first = 2 * u64::from(i);
        (random.uniform(first), random.uniform(first + 1))
    }

    fn in_cell(&self, i: u32, (dx, dy): (f64, f64)) -> (f64, f64) {
        let cells = f64::from(self.cells);
        let (column, row) = (i % self.cells, i / self.cells);
        let [x, y] = [(column, dx), (row, dy)].map(|(cell, d)| (f64::from(cell) + d) / cells);
        (x, y)
    }
}

impl Sampler for Samples {
    fn samples(&self) -> u32 {
        self.count
    }

    fn place(&self, i: u32, column: u32, row: u32) -> (f64, f64) {
        match self.sampling {
            Sampling::Center => (0.5, 0.5),
            Sampling::Regular => self.in_cell(i, (0.5, 0.5)),
            Sampling::Random => self.jitter(i, column, row),
            Sampling::Stratified => self.in_cell(i, self.jitter(i, column, row)),
        }
    }
}
