//! `Experiment`: error against work, the price of a smaller error.
//!
//! As in work-precision diagrams of solvers of differential equations, several
//! methods solve one problem with a parameter that goes from coarse to fine. Each
//! value is a point of the diagram: the error, and its price. The price is counted,
//! which is the same on every machine, and timed, which is not.

use std::fmt;

pub use crate::curve::{Curve, ErrorBound, Slope, TaskSet};
use crate::fit::Fit;
pub use crate::interval::Interval;
pub use crate::point::{Errors, Point, Times};

/// Half a grey level of an 8-bit picture: smaller errors can't be seen.
pub const HALF_GREY_LEVEL: f64 = 1.0 / 510.0;

/// The unit of an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit<'a> {
    /// The exact value, in words, of which the error is a fraction: `FractionOf("t")`. A method whose
    /// error is 1 has no digit right.
    FractionOf(&'a str),
    /// The light of a pixel, from black, 0, to white, 1.
    Light,
    /// The fraction of wrong answers, from 0 to 1. It follows no power law, because it
    /// has a largest value.
    Fraction,
    /// Another unit, in words.
    Other(&'a str),
}

impl fmt::Display for Unit<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::FractionOf(value) => return write!(f, "fraction of {value}"),
            Self::Light => "white = 1",
            Self::Fraction => "all = 1",
            Self::Other(name) => name,
        })
    }
}

/// The horizontal axis against which the slopes of an experiment are taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// The counted work, where the parameter changes the price of the method.
    Work,
    /// The parameter itself, where it changes the problem and not the method.
    Parameter,
}

/// What the curves of an experiment stand for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Curves {
    /// Several methods for one problem. One can beat another.
    Methods,
    /// One method for several problems. None can beat another.
    Problems,
}

/// A comparison of methods: the question, the words for its axes, and the measurement.
///
/// Build one as a literal, with [`Experiment::new`] for the fields that stay as they are.
pub struct Experiment<'a> {
    /// The name on the command line, in kebab case.
    pub name: &'a str,
    /// The question that it answers, in one line: the title of its plots.
    pub question: &'a str,
    /// The parameter that goes from coarse to fine, with its unit in brackets if it has one.
    pub parameter: &'a str,
    /// The counted work, such as rays.
    pub work: &'a str,
    /// The axis that slopes are taken against.
    pub against: Axis,
    /// The error without its unit: "rms error of t".
    pub error: &'a str,
    /// The unit of the error.
    pub unit: Unit<'a>,
    /// The exact value that errors are differences from, "against 30 digits", and the error
    /// that a miss counts as.
    pub exact: &'a str,
    /// The name of the experiment with the opposite mistake, at the same inputs with the same
    /// methods: a method that never hits anything has no acne, and leaks everywhere. Both are one
    /// plot, and have one front.
    pub opposite: Option<&'a str>,
    /// The seeds of its random numbers, if it takes any.
    pub seeds: &'a [u64],
    /// Whether the curves are methods or problems.
    pub curves_are: Curves,
    /// Measures the errors of all curves, and prepares their runs to be timed. The first curve is
    /// the baseline of the times.
    pub curves: Box<dyn Fn() -> Vec<Curve<'a>> + 'a>,
}

impl<'a> Experiment<'a> {
    /// An experiment without words and methods, on errors of light against work, without random
    /// numbers.
    pub fn new(name: &'a str) -> Self {
        Self {
            name,
            question: "",
            parameter: "",
            work: "",
            against: Axis::Work,
            error: "",
            unit: Unit::Light,
            exact: "",
            opposite: None,
            seeds: &[],
            curves_are: Curves::Methods,
            curves: Box::new(Vec::new),
        }
    }

    /// The line through the errors of a curve. None for fractions.
    pub fn fit(&self, curve: &Curve) -> Option<Fit> {
        if self.unit == Unit::Fraction {
            return None;
        }
        curve.fit(self.against)
    }
}

/// The largest deviation of a measured slope from theory.
const SLOPE_TOLERANCE: f64 = 0.05;

/// Checks in a test that the measured slopes and errors agree with theory.
///
/// # Panics
///
/// If there is no curve, or if one does not agree; the message lists all of them.
pub fn check(experiment: &Experiment) {
    let curves = (experiment.curves)();
    let (mut points, mut wrong) = (0, Vec::new());
    for curve in &curves {
        points += curve.points.len();
        wrong.extend(wrong_slope(experiment, curve));
        wrong.extend(errors_out_of_bound(curve));
    }
    let name = experiment.name;
    assert!(points > 1, "{name} has no points");
    assert!(wrong.is_empty(), "{name}: {}", wrong.join("; "));
}

/// The measured slope in words, if it is not the one of theory.
fn wrong_slope(experiment: &Experiment, curve: &Curve) -> Option<String> {
    let expected = curve.slope.as_ref()?.value;
    let fit = experiment.fit(curve);
    let is_right = fit
        .is_some_and(|fit| fit.is_power_law() && (fit.slope - expected).abs() <= SLOPE_TOLERANCE);
    (!is_right).then(|| format!("{}: {fit:?}, not {expected}", curve.method))
}

/// The errors in words that are greater than theory allows.
fn errors_out_of_bound(curve: &Curve) -> Vec<String> {
    let mut wrong = Vec::new();
    let Some(bound) = &curve.bound else {
        return wrong;
    };
    for Point {
        parameter, errors, ..
    } in &curve.points
    {
        let is_within = errors.rms <= bound.error;
        if bound.between.contains(parameter) && !is_within {
            wrong.push(format!("{} at {parameter}: {:e}", curve.method, errors.rms));
        }
    }
    wrong
}

#[cfg(test)]
mod tests;
