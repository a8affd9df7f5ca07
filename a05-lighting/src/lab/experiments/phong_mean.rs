//! The highlight of a ball that is lit from the eye has the mean
//! `1 / (2 (P + 1))` for every exponent P. A grid of n by n points has this
//! mean as soon as it resolves the highlight, so that only the rounding error of
//! the sum remains.

use std::f64::consts::PI;

use a03_rays_cameras::lab::experiments::neumaier;
use measure::experiment::{Axis, Curve, Experiment, Point, Unit};

const EXPONENTS: [f64; 8] = [8.0, 9.0, 10.0, 11.0, 12.0, 13.0, 14.0, 15.0];

pub fn experiment() -> Experiment<'static> {
    Experiment {
        name: "phong-mean",
        about: "What does adding up many pixels cost in digits?",
        knob: "pixels across",
        work: "pixels",
        error: "rms error of the mean highlight",
        unit: Unit::Other("largest highlight = 1"),
        exact: "against 1 / (2 (P + 1)) for the exponents P = 8 to 15",
        seeds: &[],
        against: Axis::Knob,
        curves: Box::new(|effort| {
            let sizes = &[64, 128, 256, 512, 1024, 2048, 4096][..effort.choose(4, 7)];
            let curve = |method, sum: Sum| {
                let point = |&across: &u32| {
                    let mean = move |p| mean(across, p, sum);
                    let errors = EXPONENTS.map(|p| mean(p) - 1.0 / (2.0 * (p + 1.0)));
                    let across = f64::from(across);
                    Point::new(across, across * across, errors, move || mean(10.0))
                };
                Curve::new(method, sizes.iter().map(point))
            };
            vec![
                curve("plain sum", |terms| terms.sum()),
                curve("Neumaier's sum", |terms| neumaier(terms)).with_remark(
                    "not in the renderer: a pixel adds up few samples, and the rounding of \
                     thousands is far below what can be seen",
                ),
            ]
        }),
    }
}

/// A method to add up terms.
type Sum = fn(&mut dyn Iterator<Item = f64>) -> f64;

/// The mean over the disc of a ball in a picture of `across` by `across`
/// pixels. At the distance ρ from the middle, the cosine of the angle between the
/// mirrored light and the eye is `1 - 2 ρ²`.
fn mean(across: u32, exponent: f64, sum: Sum) -> f64 {
    let pixel = 2.0 / f64::from(across);
    let place = move |i: u32| (f64::from(i) + 0.5) * pixel - 1.0;
    let highlight = move |x: f64, y: f64| {
        let cosine = 1.0 - 2.0 * (x * x + y * y);
        libm::pow(cosine.max(0.0), exponent)
    };
    let row = |y: u32| (0..across).map(move |x| highlight(place(x), place(y)));
    sum(&mut (0..across).flat_map(row)) * pixel * pixel / PI
}
