//! Methods to place samples in a pixel: the renderer's, and two more.

use common::Sampling::{self, Random, Regular, Stratified};
use common::Settings;

use a03_rays_cameras::{PixelRandom, Sampler};

/// A method with its name.
pub struct Method {
    pub name: &'static str,
    pub places: Places,
}

/// The positions of some samples in the pixel of a column and a row.
pub type Places = fn(column: u32, row: u32, samples: u32) -> Positions;

/// Positions in a pixel, from its lower left corner, (0, 0), to its upper right one, (1, 1).
pub type Positions = Box<dyn Iterator<Item = (f64, f64)>>;

/// The methods that are compared.
pub const METHODS: [Method; 5] = [
    Method {
        name: "random",
        places: |column, row, samples| sampled(Random, column, row, samples),
    },
    Method {
        name: "regular",
        places: |column, row, samples| sampled(Regular, column, row, samples),
    },
    Method {
        name: "stratified",
        places: |column, row, samples| sampled(Stratified, column, row, samples),
    },
    Method {
        name: "n rooks",
        places: n_rooks,
    },
    Method {
        name: "R2",
        places: r2,
    },
];

/// The renderer's own sampling.
fn sampled(sampling: Sampling, column: u32, row: u32, samples: u32) -> Positions {
    let settings = Settings {
        sampling,
        samples,
        ..Settings::default()
    };
    Box::new(Sampler::new(&settings).places(column, row))
}

/// `n` rooks on a board of n by n squares that do not threaten each other: one
/// sample in each row and in each column (Shirley: Discrepancy as a Quality
/// Measure for Sample Distributions, 1991).
fn n_rooks(column: u32, row: u32, n: u32) -> Positions {
    let random = PixelRandom::new(1, column, row);
    let mut drawn = 0;
    let mut uniform = move || {
        drawn += 1;
        random.uniform(drawn - 1)
    };
    let mut files: Vec<u32> = (0..n).collect();
    for last in (1..files.len()).rev() {
        files.swap(last, (uniform() * (last + 1) as f64) as usize);
    }
    let squares = files.into_iter().zip(0_u32..);
    Box::new(squares.map(move |(file, rank)| {
        let (dx, dy) = (uniform(), uniform());
        let n = f64::from(n);
        ((f64::from(file) + dx) / n, (f64::from(rank) + dy) / n)
    }))
}

/// The multiples of a pair of irrational numbers, which fill the pixel evenly,
/// shifted by a random pair for every pixel (Roberts: The Unreasonable Effectiveness of
/// Quasirandom Sequences, 2018).
fn r2(column: u32, row: u32, n: u32) -> Positions {
    /// The plastic number, which solves p^3 = p + 1.
    const P: f64 = 1.324_717_957_244_746;
    let random = PixelRandom::new(2, column, row);
    let (dx, dy) = (random.uniform(0), random.uniform(1));
    Box::new((0..n).map(move |i| {
        let i = f64::from(i);
        (fraction(dx + i / P), fraction(dy + i / (P * P)))
    }))
}

fn fraction(x: f64) -> f64 {
    x - x.floor()
}
