//! Error against work: the price of a smaller error.
//!
//! As in work-precision diagrams of solvers of differential equations, several
//! methods solve one problem with a parameter that goes from coarse to fine. Each
//! value is a point of the diagram: the error, and its price. The price is counted,
//! which is the same on every machine, and timed, which is not.

use std::fmt;

use crate::Effort;
pub use crate::curve::{Curve, Point};
pub use crate::deviation::{Deviation, Problem};
use crate::fit::Fit;

/// Half a grey level of an 8-bit picture: smaller errors can't be seen.
pub const HALF_GREY_LEVEL: f64 = 1.0 / 510.0;

/// The unit of an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit<'a> {
    /// The light of a pixel, from black, 0, to white, 1.
    Light,
    /// The fraction of wrong answers, from 0 to 1. It follows no power law, because it
    /// has a largest value.
    Share,
    /// Another unit, in words.
    Other(&'a str),
}

impl fmt::Display for Unit<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Light => "white = 1",
            Self::Share => "all = 1",
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

/// A comparison of methods.
pub struct Experiment<'a> {
    /// The name on the command line, in kebab case.
    pub name: &'a str,
    pub(crate) about: &'a str,
    pub(crate) parameter: &'a str,
    pub(crate) work: &'a str,
    pub(crate) error: &'a str,
    pub(crate) unit: Unit<'a>,
    pub(crate) exact: &'a str,
    pub(crate) seeds: &'a [u64],
    pub(crate) against: Axis,
    pub(crate) of_problems: bool,
    /// Measures all methods. The first is the baseline of the times.
    pub curves: Box<dyn Fn(Effort) -> Vec<Curve<'a>> + 'a>,
}

impl<'a> Experiment<'a> {
    /// An experiment without methods, on errors of light, without random numbers.
    pub fn new(name: &'a str) -> Self {
        Self {
            name,
            about: "",
            parameter: "",
            work: "",
            error: "",
            unit: Unit::Light,
            exact: "",
            seeds: &[],
            against: Axis::Work,
            of_problems: false,
            curves: Box::new(|_| Vec::new()),
        }
    }

    /// Adds the question, in one line: the title of its plots.
    pub fn asking(self, about: &'a str) -> Self {
        Self { about, ..self }
    }

    /// Adds the axis that slopes are taken against; the parameter, with its unit in brackets
    /// if it has one; and the counted work, such as rays.
    pub fn over(mut self, against: Axis, parameter: &'a str, work: &'a str) -> Self {
        (self.against, self.parameter, self.work) = (against, parameter, work);
        self
    }

    /// Adds the error, without its unit: "rms error of t".
    pub fn with_error(self, error: &'a str) -> Self {
        Self { error, ..self }
    }

    /// Adds the unit of the error.
    pub fn with_unit(self, unit: Unit<'a>) -> Self {
        Self { unit, ..self }
    }

    /// Adds the exact value: "against 30 digits", and the error of a miss.
    pub fn with_exact(self, exact: &'a str) -> Self {
        Self { exact, ..self }
    }

    /// One method for several problems, each with a curve: none can beat another.
    pub fn of_problems(self) -> Self {
        Self {
            of_problems: true,
            ..self
        }
    }

    /// Adds the seeds of its random numbers.
    pub fn with_seeds(self, seeds: &'a [u64]) -> Self {
        Self { seeds, ..self }
    }

    /// Adds the measurement of all methods.
    pub fn with_curves(mut self, curves: impl Fn(Effort) -> Vec<Curve<'a>> + 'a) -> Self {
        self.curves = Box::new(curves);
        self
    }

    /// The line through the errors of a curve. None for fractions.
    pub fn fit(&self, curve: &Curve) -> Option<Fit> {
        let fit = curve.fit(self.against)?;
        (self.unit != Unit::Share).then_some(fit)
    }

    /// Whether half a grey level is a mark for these errors: they are of light, and a
    /// method exists whose error falls as its work grows.
    pub fn can_be_seen(&self, curves: &[Curve]) -> bool {
        let falls = |curve: &Curve| match &curve.points[..] {
            [coarse, .., fine] => coarse.work < fine.work && fine.rms < coarse.rms,
            _ => false,
        };
        self.unit == Unit::Light && curves.iter().any(falls)
    }
}

/// The largest deviation of a measured slope from theory.
const SLOPE_TOLERANCE: f64 = 0.05;

/// The Pareto front, by curve and point: true for a point if no other has both
/// less work and a smaller error.
pub fn pareto_front(curves: &[Curve]) -> Vec<Vec<bool>> {
    let beats = |a: &Point, b: &Point| {
        a.work <= b.work && a.rms <= b.rms && (a.work < b.work || a.rms < b.rms)
    };
    let all: Vec<_> = curves.iter().flat_map(|curve| &curve.points).collect();
    let is_beaten = |point: &Point| all.iter().any(|one| beats(one, point));
    let unbeaten = |point: &Point| !is_beaten(point);
    let of_curve = |curve: &Curve| curve.points.iter().map(unbeaten).collect();
    curves.iter().map(of_curve).collect()
}

/// Checks in a test that the measured slopes and errors agree with theory.
///
/// # Panics
///
/// If there is no curve, or if one does not agree; the message lists all of them.
pub fn check(experiment: &Experiment, effort: Effort) {
    let curves = (experiment.curves)(effort);
    let mut wrong = Vec::new();
    for curve in &curves {
        let fit = experiment.fit(curve);
        if let Some((expected, _)) = curve.slope {
            let off = |fit: Fit| (fit.slope - expected).abs();
            if !fit.is_some_and(|fit| fit.is_power_law() && off(fit) <= SLOPE_TOLERANCE) {
                wrong.push(format!("{}: {fit:?}, not {expected}", curve.method));
            }
        }
        for Point { parameter, rms, .. } in &curve.points {
            let bound = curve.bound.as_ref();
            let bound = bound.filter(|(_, range)| range.contains(parameter));
            if bound.is_some_and(|(most, _)| rms.is_nan() || rms > most) {
                wrong.push(format!("{} at {parameter}: {rms:e}", curve.method));
            }
        }
    }
    let name = experiment.name;
    let count: usize = curves.iter().map(|curve| curve.points.len()).sum();
    assert!(count > 1, "{name} has no points");
    assert!(wrong.is_empty(), "{name}: {}", wrong.join("; "));
}

#[cfg(test)]
mod tests;
