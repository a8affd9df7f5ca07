//! Error against work: methods to place the samples in a pixel, and to sum them.
//!
//! All samplers are tested on three kinds of pixels, because positions that are
//! good for one kind may be poor for another. Every pixel's mean has a closed
//! form, so no reference picture with more samples is needed.

mod coverage;
mod summation;

use common::Sampling::{self, Random, Regular, Stratified};
use common::Settings;
use measure::experiment::{Axis, Curve, Experiment, Point};

pub use coverage::{RADIUS, disc_coverage};
use coverage::{in_disc, in_stripe, irradiance, lit, stripes};
pub use summation::neumaier;

use a03_rays_cameras::{PixelRandom, Sampler};

/// All experiments of the stage. Slopes at curved edges: Mitchell, Consequences of
/// Stratified Sampling in Graphics, 1996. At level edges, a regular grid of n samples has
/// only sqrt(n) heights, and n rooks have n.
#[rustfmt::skip]
pub fn experiments() -> Vec<Experiment<'static>> {
    vec![
        samples("samples-curved-edge", "Where should samples lie in a pixel that a disc's edge crosses?",
            || (|x, y| in_disc(x, y).into(), pixels(64, 64, disc_coverage)),
            [Some(-0.5), Some(-0.75), Some(-0.75), Some(-0.5), None]),
        samples("samples-level-edge", "Where should samples lie in a pixel that a level edge crosses?",
            || (|_, y| in_stripe(y).into(), pixels(1, 1000, |_, y| stripes(y))),
            [Some(-0.5), Some(-0.5), Some(-0.75), Some(-1.0), None]),
        samples("samples-smooth-shading", "Where should samples lie in a pixel of smooth shading?",
            || (lit, pixels(16, 16, irradiance)),
            [Some(-0.5), Some(-1.0), Some(-1.0), None, None]),
        summation::experiment(),
    ]
}

/// The radiance at a position of the picture, in pixels; and the columns and rows of the
/// pixels that are not constant, with their known means.
type Task = (fn(f64, f64) -> f64, Vec<(u32, u32, f64)>);

fn pixels(width: u32, height: u32, mean: fn(f64, f64) -> f64) -> Vec<(u32, u32, f64)> {
    let row = |y: u32| (0..width).map(move |x| (x, y, mean(x.into(), y.into())));
    let is_constant = |mean: f64| !(1e-9..1.0 - 1e-9).contains(&mean);
    let all = (0..height).flat_map(row);
    all.filter(|(_, _, mean)| !is_constant(*mean)).collect()
}

/// An experiment with all samplers, and their slopes in the same order.
fn samples(
    name: &'static str,
    about: &'static str,
    task: fn() -> Task,
    slopes: [Option<f64>; 5],
) -> Experiment<'static> {
    Experiment::new(name)
        .asking(about)
        .over(Axis::Work, "samples a pixel", "rays a pixel")
        .with_error("rms error of a pixel")
        .with_exact("against the pixel's mean in closed form")
        .with_seeds(&[0, 1, 2])
        .with_curves(move |effort| {
            let methods: [(&str, TestPaths); 5] = [
                ("random", |x, y, n| sampled(Random, x, y, n)),
                ("regular", |x, y, n| sampled(Regular, x, y, n)),
                ("stratified", |x, y, n| sampled(Stratified, x, y, n)),
                ("n rooks", n_rooks),
                ("R2", r2),
            ];
            let numbers = &[1, 4, 16, 64, 256, 1024, 4096][..effort.choose(6, 7)];
            let curve = |((method, places), slope): ((_, TestPaths), Option<f64>)| {
                let curve = Curve::new(method, numbers.iter().map(|n| point(task(), places, *n)));
                curve.with_slope(slope, (16.0, 4096.0))
            };
            methods.into_iter().zip(slopes).map(curve).collect()
        })
}

fn point((radiance, pixels): Task, places: TestPaths, n: u32) -> Point<'static> {
    let mean = move |x: u32, y: u32| {
        let at = |(dx, dy): (f64, f64)| radiance(f64::from(x) + dx, f64::from(y) + dy);
        places(x, y, n).map(at).sum::<f64>() / f64::from(n)
    };
    let error = |(x, y, exact): &(u32, u32, f64)| mean(*x, *y) - exact;
    let errors: Vec<_> = pixels.iter().map(error).collect();
    let run = move || pixels.iter().map(|(x, y, _)| mean(*x, *y)).sum::<f64>();
    Point::new(n.into(), n.into(), errors, run)
}

/// The positions of some samples in the pixel of a column and a row.
type TestPaths = fn(u32, u32, u32) -> Iter;
type Iter = Box<dyn Iterator<Item = (f64, f64)>>;

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
fn n_rooks(x: u32, y: u32, n: u32) -> Iter {
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
fn r2(x: u32, y: u32, n: u32) -> Iter {
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
