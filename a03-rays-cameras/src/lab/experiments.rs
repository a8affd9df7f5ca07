//! Error against work: methods to place the samples in a pixel, and to sum them.
//!
//! All samplers are tested on three kinds of pixels, because positions that are
//! good for one kind may be poor for another. Every pixel's mean has a closed
//! form, so no reference picture with more samples is needed.

mod adaptive;
mod coverage;
mod places;
mod summation;

use common::Sampling;
use measure::Effort;
use measure::experiment::{Axis, Curve, Experiment, Point, Unit};

pub use coverage::{DISC, disc_coverage};
use coverage::{irradiance, lit, stripes};
use places::{Places, n_rooks, r2, with_sampler};
pub use summation::Neumaier;

/// All experiments of the stage. Slopes at curved edges: Mitchell, Consequences of
/// Stratified Sampling in Graphics, 1996. At level edges, a regular grid of n samples has
/// only sqrt(n) heights, and n rooks have n.
#[rustfmt::skip]
pub fn experiments() -> Vec<Experiment<'static>> {
    vec![
        samples("samples-curved-edge", "Where should samples lie in a pixel that a disc's edge crosses?",
            curved_edge, [Some(-0.5), Some(-0.75), Some(-0.75), Some(-0.5), None]),
        samples("samples-level-edge", "Where should samples lie in a pixel that a level edge crosses?",
            level_edge, [Some(-0.5), Some(-0.5), Some(-0.75), Some(-1.0), None]),
        samples("samples-smooth-shading", "Where should samples lie in a pixel of smooth shading?",
            smooth_shading, [Some(-0.5), Some(-1.0), Some(-1.0), None, None]),
        adaptive::experiment(),
        summation::experiment(),
    ]
}

/// A picture with the known mean of each pixel.
struct Task {
    /// Radiance at a position of the picture, in pixels.
    radiance: fn(f64, f64) -> f64,
    /// The pixels that are not constant, with their means.
    pixels: Vec<(u32, u32, f64)>,
}

/// Whether a part of the pixel is light and a part is dark.
fn is_edge((_, _, mean): &(u32, u32, f64)) -> bool {
    (1e-9..1.0 - 1e-9).contains(mean)
}

fn pixels(width: u32, height: u32, mean: fn(f64, f64) -> f64) -> Vec<(u32, u32, f64)> {
    let row = |y: u32| (0..width).map(move |x| (x, y, mean(x.into(), y.into())));
    (0..height).flat_map(row).collect()
}

fn curved_edge() -> Task {
    let mut pixels = pixels(64, 64, disc_coverage);
    pixels.retain(is_edge);
    Task {
        radiance: |x, y| f64::from(u8::from(DISC.contains(x, y))),
        pixels,
    }
}

fn level_edge() -> Task {
    let mut pixels = pixels(1, 1000, |_, y| stripes(y));
    pixels.retain(is_edge);
    Task {
        radiance: |_, y| f64::from(u8::from(coverage::in_stripe(y))),
        pixels,
    }
}

fn smooth_shading() -> Task {
    Task {
        radiance: lit,
        pixels: pixels(16, 16, irradiance),
    }
}

/// An experiment with all samplers, and their slopes in the same order.
fn samples(
    name: &'static str,
    about: &'static str,
    task: fn() -> Task,
    slopes: [Option<f64>; 5],
) -> Experiment<'static> {
    let curves = move |effort: Effort| {
        let methods: [(&str, &str, Places); 5] = [
            ("random", "", with_sampler(Sampling::Random)),
            ("regular", "", with_sampler(Sampling::Regular)),
            ("stratified", "", with_sampler(Sampling::Stratified)),
            ("n rooks", N_ROOKS, n_rooks),
            ("R2", R2, r2),
        ];
        let curve = |((method, remark, places), slope): ((_, _, Places), Option<f64>)| {
            let curve = Curve::new(method, points(task, places, effort));
            curve.with_slope(slope, (16.0, 4096.0)).with_remark(remark)
        };
        methods.into_iter().zip(slopes).map(curve).collect()
    };
    Experiment {
        name,
        about,
        knob: "samples a pixel",
        work: "rays a pixel",
        error: "rms error of a pixel",
        unit: Unit::Light,
        exact: "against the pixel's mean in closed form",
        seeds: &[0, 1, 2],
        against: Axis::Work,
        curves: Box::new(curves),
    }
}

const N_ROOKS: &str =
    "not in the renderer: best at level edges only, and every pixel needs a shuffled list";
const R2: &str = "not in the renderer: about as good as stratified, and slower";

fn points(task: fn() -> Task, places: Places, effort: Effort) -> Vec<Point<'static>> {
    let numbers = &[1_u32, 4, 16, 64, 256, 1024, 4096][..effort.choose(6, 7)];
    let point = |&n: &u32| {
        let Task { radiance, pixels } = task();
        let mean = move |(x, y): (u32, u32)| {
            let at = |(dx, dy): (f64, f64)| radiance(f64::from(x) + dx, f64::from(y) + dy);
            let places = places(x, y, n);
            places.map(at).sum::<f64>() / f64::from(n)
        };
        let errors: Vec<_> = pixels
            .iter()
            .map(|(x, y, exact)| mean((*x, *y)) - exact)
            .collect();
        let run = move || pixels.iter().map(|(x, y, _)| mean((*x, *y))).sum();
        Point::new(n.into(), n.into(), errors, run)
    };
    numbers.iter().map(point).collect()
}
