//! The mean and the power of highlights.

use std::f64::consts::PI;

use a02_math::lab::exact::DoubleDouble;
use a03_rays_cameras::lab::experiments::neumaier;
use measure::experiment::{Axis, Curve, Experiment, Point, Unit};

use crate::power::squaring;

/// The highlight of a ball that is lit from the eye has the mean
/// `1 / (2 (P + 1))` for every exponent P. A grid of n by n points has this
/// mean as soon as it resolves the highlight, so that only the rounding error of
/// the sum remains.
pub fn mean() -> Experiment<'static> {
    Experiment::new("phong-mean")
        .asking("What does adding up many pixels cost in digits?")
        .over(Axis::Knob, "pixels across", "pixels")
        .with_error("rms error of the mean highlight")
        .with_unit(Unit::Other("largest highlight = 1"))
        .with_exact("against 1 / (2 (P + 1)) for the exponents P = 8 to 15")
        .with_curves(|effort| {
            let sizes = &[64, 128, 256, 512, 1024, 2048, 4096][..effort.choose(4, 7)];
            let curve = |method, sum: Sum| {
                let points = sizes.iter().map(|&across: &u32| {
                    let mean = move |exponent: u32| mean_highlight(across, exponent, sum);
                    let errors = (8..16).map(|p| mean(p) - 1.0 / f64::from(2 * (p + 1)));
                    let across = f64::from(across);
                    Point::new(across, across * across, errors, move || mean(10))
                });
                Curve::new(method, points)
            };
            vec![
                curve("plain sum", |terms| terms.sum()),
                curve("Neumaier's sum", |terms| neumaier(terms)),
            ]
        })
}

/// A method to add up terms.
type Sum = fn(&mut dyn Iterator<Item = f64>) -> f64;

/// The mean over the disc of a ball in a picture of `across` by `across`
/// pixels. At the distance ρ from the middle, the cosine of the angle between the
/// mirrored light and the eye is `1 - 2 ρ²`.
fn mean_highlight(across: u32, exponent: u32, sum: Sum) -> f64 {
    let pixel = 2.0 / f64::from(across);
    let places = (0..across).map(|i| (f64::from(i) + 0.5) * pixel - 1.0);
    let highlights = places.clone().flat_map(|y| {
        let cosine = move |x| 1.0 - 2.0 * (x * x + y * y);
        let row = places.clone().map(cosine);
        row.map(|cosine: f64| libm::pow(cosine.max(0.0), exponent.into()))
    });
    sum(&mut { highlights }) * pixel * pixel / PI
}

/// `base^P` by repeated squaring with 31 digits. The rounding errors add up to P units of the
/// last one, so that 19 digits are left for the greatest P, 1e12.
fn exact(base: DoubleDouble, exponent: u64) -> DoubleDouble {
    match exponent {
        0 => 1.0.into(),
        odd if odd % 2 == 1 => base * exact(base, odd - 1),
        even => exact(base * base, even / 2),
    }
}

/// A power of `1 - d`.
type Power = fn(d: f64, exponent: f64) -> f64;

/// Rounding the cosine changes its P-th power by the relative error eps P / 4,
/// even if the power is exact; only methods that use 1 - cosine can do better.
pub fn power() -> Experiment<'static> {
    Experiment::new("phong-power")
        .asking("How exact is the power of a highlight, and what does it cost?")
        .over(Axis::Knob, "exponent", "powers")
        .with_error("rms error of the power")
        .with_unit(Unit::Other("share of it"))
        .with_exact("against powers with 19 digits or more")
        .with_curves(|effort| {
            let count = effort.choose(4_096, 65_536);
            let curve = |method, slope: Option<f64>, power: Power| {
                let points = [1e2, 1e4, 1e6, 1e9, 1e12].map(|exponent| {
                    // The cosine is 1 - d, with d = 1/8, 3/8 ... 15/8 of 1/P.
                    let eighths = [1.0, 3.0, 5.0, 7.0, 9.0, 11.0, 13.0, 15.0];
                    let distances = eighths.map(|eighth| eighth / 8.0 / exponent);
                    let error = |d: f64| {
                        let cosine = DoubleDouble::from(1.0) - d.into();
                        let exact = exact(cosine, exponent as u64).value();
                        (power(d, exponent) - exact) / exact
                    };
                    let run = move || {
                        let inputs = distances.iter().cycle().take(count);
                        inputs.map(|d| power(*d, exponent)).sum::<f64>()
                    };
                    Point::new(exponent, count as f64, distances.map(error), run)
                });
                Curve::new(method, points).with_slope(slope, (1e2, 1e12))
            };
            vec![
                curve("libm::pow", Some(1.0), |d, p| libm::pow(1.0 - d, p)),
                curve("repeated squaring", Some(1.0), |d, p| {
                    squaring(1.0 - d, p as u64)
                }),
                curve("exp(P ln1p(-d))", None, |d, p| {
                    libm::exp(p * libm::log1p(-d))
                }),
            ]
        })
}
