//! The power of highlights.

use a02_lab::exact::DoubleDouble;
use measure::Effort;
use measure::experiment::{Axis, Curve, Deviation, Errors, Experiment, Point, Slope, Times, Unit};

use a05_lighting::power::squaring;

/// Rounding the cosine changes its P-th power by the relative error eps P / 4,
/// even if the power is exact; only methods that use 1 - cosine can do better.
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

/// A method for the power of the cosine `1 - d`, and its condition.
#[derive(Clone, Copy)]
struct Method {
    power: fn(d: f64, exponent: f64) -> f64,
    condition: fn(d: f64, exponent: f64) -> f64,
}

const POW: Method = Method {
    power: |d, exponent| libm::pow(1.0 - d, exponent),
    condition: |_, exponent| exponent,
};

const SQUARING: Method = Method {
    power: |d, exponent| squaring(1.0 - d, exponent as u64),
    condition: |_, exponent| exponent,
};

/// Given is `d`, of which the power hardly changes.
const EXPONENTIAL: Method = Method {
    power: |d, exponent| libm::exp(exponent * libm::log1p(-d)),
    condition: |d, exponent| f64::max(1.0, d * exponent),
};

fn curves(effort: Effort) -> Vec<Curve<'static>> {
    let count = effort.choose(4_096, 65_536);
    let curve = |name, method: Method| {
        let exponents = [1e2, 1e4, 1e6, 1e9, 1e12];
        Curve::new(
            name,
            exponents.map(|exponent| method.point(exponent, count)),
        )
    };
    let as_the_exponent = Slope {
        value: 1.0,
        between: 1e2..=1e12,
    };
    vec![
        Curve {
            slope: Some(as_the_exponent.clone()),
            ..curve("libm::pow", POW)
        },
        Curve {
            slope: Some(as_the_exponent),
            ..curve("repeated squaring", SQUARING)
        },
        curve("exp(P ln1p(-d))", EXPONENTIAL),
    ]
}

impl Method {
    /// The measurement of some powers of cosines near 1: d = 1/8, 3/8 ... 15/8 of 1/P.
    fn point(self, exponent: f64, count: usize) -> Point<'static> {
        let distances =
            [1.0, 3.0, 5.0, 7.0, 9.0, 11.0, 13.0, 15.0].map(|eighths| eighths / 8.0 / exponent);
        let mut errors = Vec::new();
        for d in distances {
            let cosine = DoubleDouble::from(1.0) - d.into();
            let exact = cosine.power(exponent as u64).value();
            let error = (self.power)(d, exponent) - exact;
            let condition = (self.condition)(d, exponent);
            errors.push(Deviation::new(error, exact, condition).as_fraction_of(exact));
        }
        Point {
            parameter: exponent,
            work: count as f64,
            errors: Errors::of(errors),
            times: Times::of(move || {
                let inputs = distances.iter().cycle().take(count);
                inputs.map(|d| (self.power)(*d, exponent)).sum::<f64>()
            }),
        }
    }
}
