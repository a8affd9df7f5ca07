//! The power of highlights.

use measure::exact::DoubleDouble;
use measure::experiment::{Axis, Curve, Errors, Experiment, Point, Slope, Times, Unit};

use a05_lighting::power::squaring;

/// Rounding the cosine changes its P-th power by the relative error eps P / 4,
/// even if the power is exact.
pub fn power() -> Experiment<'static> {
    Experiment {
        question: "How exact is the power of a highlight, and what does it cost?",
        parameter: "exponent",
        work: "powers",
        against: Axis::Parameter,
        error: "rms error of the power",
        unit: Unit::FractionOf("it"),
        exact: "against powers with 19 digits or more",
        curves: Box::new(curves),
        ..Experiment::new("phong-power")
    }
}

/// The power of a cosine.
type Power = fn(f64, f64) -> f64;

fn curves() -> Vec<Curve<'static>> {
    let curve = |name, power: Power| {
        let exponents = [1e2, 1e4, 1e6, 1e9, 1e12];
        let as_the_exponent = Slope {
            value: 1.0,
            between: 1e2..=1e12,
        };
        Curve {
            slope: Some(as_the_exponent),
            ..Curve::new(name, exponents.map(|exponent| point(power, exponent)))
        }
    };
    vec![
        curve("libm::pow", libm::pow),
        curve("repeated squaring", |cosine, exponent| {
            squaring(cosine, exponent as u64)
        }),
    ]
}

/// The number of powers that are timed.
const COUNT: usize = 4_096;

/// The measurement of some powers of cosines near 1: 1 - d with d = 1/8, 3/8 ... 15/8 of 1/P.
fn point(power: Power, exponent: f64) -> Point<'static> {
    let distances =
        [1.0, 3.0, 5.0, 7.0, 9.0, 11.0, 13.0, 15.0].map(|eighths| eighths / 8.0 / exponent);
    let mut errors = Vec::new();
    for d in distances {
        let cosine = DoubleDouble::from(1.0) - d.into();
        let exact = cosine.power(exponent as u64).value();
        errors.push((power(1.0 - d, exponent) - exact) / exact);
    }
    Point {
        parameter: exponent,
        work: COUNT as f64,
        errors: Errors::of(errors),
        times: Times::of(move || {
            let inputs = distances.iter().cycle().take(COUNT);
            inputs.map(|d| power(1.0 - *d, exponent)).sum::<f64>()
        }),
    }
}
