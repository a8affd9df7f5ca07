//! Methods to distribute samples over a pixel.

use common::{Sampling, Settings};

use crate::{PixelRandom, Sampler};

type Iter = Box<dyn Iterator<Item = (f64, f64)>>;

/// The positions of `n` samples in the pixel of this column and row.
pub type Places = fn(u32, u32, u32) -> Iter;

/// The renderer's own sampling.
pub fn sampled(sampling: Sampling, x: u32, y: u32, samples: u32) -> Iter {
    let settings = Settings {
        sampling,
        samples,
        ..Settings::default()
    };
    Box::new(Sampler::new(&settings).places(x, y))
}

/// `n` rooks on a board of n by n squares that do not threaten each other: one
/// sample in each row and in each column (Shirley: Discrepancy as a Quality
/// Measure for Sample Distributions, 1991).
pub fn n_rooks(x: u32, y: u32, n: u32) -> Iter {
    let random = PixelRandom::new(1, x, y);
    let mut number = (0..).map(move |i| random.uniform(i));
    let mut uniform = move || number.next().unwrap_or_default();
    let mut columns: Vec<u32> = (0..n).collect();
    for last in (1..columns.len()).rev() {
        columns.swap(last, (uniform() * (last + 1) as f64) as usize);
    }
    let n = f64::from(n);
    let places = columns.into_iter().zip(0_u32..);
    Box::new(places.map(move |(column, row)| {
        let (dx, dy) = (uniform(), uniform());
        ((f64::from(column) + dx) / n, (f64::from(row) + dy) / n)
    }))
}

/// The multiples of a pair of irrational numbers, which fill the pixel evenly,
/// shifted by a random pair for every pixel (Roberts: The Unreasonable Effectiveness of
/// Quasirandom Sequences, 2018).
pub fn r2(x: u32, y: u32, n: u32) -> Iter {
    /// The plastic number, which solves p^3 = p + 1.
    const P: f64 = 1.324_717_957_244_746;
    let random = PixelRandom::new(2, x, y);
    let (dx, dy) = (random.uniform(0), random.uniform(1));
    let fraction = |x: f64| x - x.floor();
    Box::new((0..n).map(move |i| {
        let i = f64::from(i);
        (fraction(dx + i / P), fraction(dy + i / (P * P)))
    }))
}
