//! The power of highlights.

use a02_lab::exact::DoubleDouble;
use measure::experiment::{Axis, Curve, Deviation, Experiment, Point, Unit};

use a05_lighting::power::squaring;

/// A power of `1 - d`, or its condition.
type Power = fn(d: f64, exponent: f64) -> f64;

/// Rounding the cosine changes its P-th power by the relative error eps P / 4,
/// even if the power is exact; only methods that use 1 - cosine can do better.
pub fn power() -> Experiment<'static> {
    Experiment::new("phong-power")
        .asking("How exact is the power of a highlight, and what does it cost?")
        .over(Axis::Parameter, "exponent", "powers")
        .with_error("rms error of the power")
        .with_unit(Unit::Other("fraction of it"))
        .with_exact("against powers with 19 digits or more")
        .with_curves(|effort| {
            let count = effort.choose(4_096, 65_536);
            let curve = |method, slope: Option<f64>, condition: Power, power: Power| {
                let points = [1e2, 1e4, 1e6, 1e9, 1e12].map(|exponent| {
                    // The cosine is 1 - d, with d = 1/8, 3/8 ... 15/8 of 1/P.
                    let eighths = [1.0, 3.0, 5.0, 7.0, 9.0, 11.0, 13.0, 15.0];
                    let distances = eighths.map(|eighth| eighth / 8.0 / exponent);
                    let error = |d: f64| {
                        let cosine = DoubleDouble::from(1.0) - d.into();
                        let exact = cosine.power(exponent as u64).value();
                        let error = power(d, exponent) - exact;
                        Deviation::new(error, exact, condition(d, exponent)).as_share_of(exact)
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
                curve(
                    "libm::pow",
                    Some(1.0),
                    |_, p| p,
                    |d, p| libm::pow(1.0 - d, p),
                ),
                curve(
                    "repeated squaring",
                    Some(1.0),
                    |_, p| p,
                    |d, p| squaring(1.0 - d, p as u64),
                ),
                // Given is 1 - cosine, of which the power hardly changes.
                curve(
                    "exp(P ln1p(-d))",
                    None,
                    |d, p| 1.0_f64.max(d * p),
                    |d, p| libm::exp(p * libm::log1p(-d)),
                ),
            ]
        })
}
