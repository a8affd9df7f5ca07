//! Error against work: the price of a smaller error.
//!
//! As in work-precision diagrams of solvers of differential equations, several
//! methods solve one problem with a parameter that goes from coarse to fine. Each
//! value is a point of the diagram: the error, and its price. The price is counted,
//! which is the same on every machine, and timed, which is not.

use std::fmt;
use std::rc::Rc;

use crate::Effort;
use crate::fit::Fit;

/// Half a grey level of an 8-bit picture: smaller errors can't be seen.
pub const HALF_GREY_LEVEL: f64 = 1.0 / 510.0;

/// The unit of an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit<'a> {
    /// The light of a pixel, from black, 0, to white, 1.
    Light,
    /// The share of wrong answers, from 0 to 1. It follows no power law, because it
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
    Knob,
}

/// A comparison of methods.
pub struct Experiment<'a> {
    /// The name on the command line, in kebab case.
    pub name: &'a str,
    /// The question, in one line: the title of its plots.
    pub about: &'a str,
    /// The parameter, with its unit in brackets if it has one.
    pub knob: &'a str,
    /// The counted work, such as rays.
    pub work: &'a str,
    /// The error, without its unit: "rms error of t".
    pub error: &'a str,
    /// The unit of the error.
    pub unit: Unit<'a>,
    /// The exact value: "against 30 digits", and the error of a miss.
    pub exact: &'a str,
    /// The seeds of its random numbers. Empty if it takes none.
    pub seeds: &'a [u64],
    /// The axis that slopes are taken against.
    pub against: Axis,
    /// Measures all methods. The first is the baseline of the times.
    pub curves: Box<dyn Fn(Effort) -> Vec<Curve<'a>> + 'a>,
}

impl Experiment<'_> {
    /// The line through the errors of a curve. None for shares.
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

/// A method at all values of the parameter.
pub struct Curve<'a> {
    /// Its name.
    pub method: &'a str,
    /// A remark for the reader: for the most exact method, why it is not in the
    /// renderer. May be empty.
    pub remark: &'a str,
    /// The slope that theory gives, if it gives one.
    pub slope: Option<Slope>,
    /// The measurements, from coarse to fine.
    pub points: Vec<Point<'a>>,
}

impl<'a> Curve<'a> {
    /// A method without a remark and without a slope in theory.
    pub fn new(method: &'a str, points: impl IntoIterator<Item = Point<'a>>) -> Self {
        Self {
            method,
            remark: "",
            slope: None,
            points: points.into_iter().collect(),
        }
    }

    /// A method for sets of tasks, each with its value of the parameter. The work is the
    /// number of tasks; `errors` are those of a set, and `run` does one task.
    pub fn of_tasks<T: 'a>(
        method: &'a str,
        sets: &[(f64, Rc<[T]>)],
        errors: impl Fn(&[T]) -> Vec<f64>,
        run: impl Fn(&T) -> f64 + Copy + 'a,
    ) -> Self {
        let points = sets.iter().map(|(knob, tasks)| {
            let all = Rc::clone(tasks);
            let run = move || all.iter().map(run).sum();
            Point::new(*knob, tasks.len() as f64, errors(tasks), run)
        });
        Self::new(method, points)
    }

    /// Adds a remark for the reader.
    pub fn with_remark(self, remark: &'a str) -> Self {
        Self { remark, ..self }
    }

    /// Adds the slope of theory, if there is one, and the range in which it holds.
    pub fn with_slope(self, expected: impl Into<Option<f64>>, between: (f64, f64)) -> Self {
        let slope = expected.into().map(|expected| Slope { expected, between });
        Self { slope, ..self }
    }
}

/// A slope of log error over log work, or over the log of the parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slope {
    /// The slope that theory gives.
    pub expected: f64,
    /// The range of the axis in which points count: below it, theory may not hold
    /// yet, and above it, rounding errors may be larger.
    pub between: (f64, f64),
}

/// The largest deviation of a measured slope from theory.
const SLOPE_TOLERANCE: f64 = 0.05;

/// One measurement.
pub struct Point<'a> {
    /// The value of the parameter.
    pub knob: f64,
    /// The counted work.
    pub work: f64,
    /// The root mean square error.
    pub rms: f64,
    /// The greatest error.
    pub max: f64,
    /// Whether the error is only estimated, by the method itself.
    pub is_estimate: bool,
    /// The work itself, to be timed, without the measurement of the error. Its
    /// result is used, so that the compiler cannot remove the work.
    pub run: Box<dyn FnMut() -> f64 + 'a>,
}

impl<'a> Point<'a> {
    /// A measurement with these errors, at least one.
    pub fn new(
        knob: f64,
        work: f64,
        errors: impl IntoIterator<Item = f64>,
        run: impl FnMut() -> f64 + 'a,
    ) -> Self {
        let (mut count, mut squares, mut max) = (0.0, 0.0, 0.0_f64);
        for error in errors {
            count += 1.0;
            squares += error * error;
            max = max.max(error.abs());
        }
        Self {
            knob,
            work,
            rms: (squares / count).sqrt(),
            max,
            is_estimate: false,
            run: Box::new(run),
        }
    }

    /// A method's own estimate of its error. It is shown beside the errors, and not
    /// compared with them.
    pub fn estimate(knob: f64, work: f64, error: f64, run: impl FnMut() -> f64 + 'a) -> Self {
        Self {
            is_estimate: true,
            ..Self::new(knob, work, [error], run)
        }
    }

    /// The coordinate on an axis.
    pub const fn on(&self, axis: Axis) -> f64 {
        match axis {
            Axis::Work => self.work,
            Axis::Knob => self.knob,
        }
    }
}

/// The share of tasks with a wrong answer, as the only error of their set.
pub fn share<T>(tasks: &[T], is_wrong: impl Fn(&&T) -> bool) -> Vec<f64> {
    let wrong = tasks.iter().filter(is_wrong).count();
    vec![wrong as f64 / tasks.len() as f64]
}

/// The Pareto front, by curve and point: true for a point if no other has both
/// less work and a smaller error. Estimates take no part.
pub fn pareto_front(curves: &[Curve]) -> Vec<Vec<bool>> {
    let beats = |a: &Point, b: &Point| {
        a.work <= b.work && a.rms <= b.rms && (a.work < b.work || a.rms < b.rms)
    };
    let all: Vec<_> = curves.iter().flat_map(|curve| &curve.points).collect();
    let is_beaten = |point: &Point| all.iter().any(|one| !one.is_estimate && beats(one, point));
    let unbeaten = |point: &Point| !point.is_estimate && !is_beaten(point);
    let of_curve = |curve: &Curve| curve.points.iter().map(unbeaten).collect();
    curves.iter().map(of_curve).collect()
}

/// Checks in a test that the measured slopes agree with theory. Returns the counted work
/// of every point, which is the same on every machine, and its error with two digits, for
/// a snapshot.
///
/// # Panics
///
/// If there is no curve, or if a slope does not agree; the message lists all of them.
pub fn checked(experiment: &Experiment, effort: Effort) -> String {
    let mut lines = vec![format!("{} ({} counted)", experiment.name, experiment.work)];
    let mut wrong = Vec::new();
    for curve in (experiment.curves)(effort) {
        let (method, fit) = (curve.method, experiment.fit(&curve));
        if let Some(Slope { expected, .. }) = curve.slope {
            let off = |fit: Fit| (fit.slope - expected).abs();
            if !fit.is_some_and(|fit| fit.is_power_law() && off(fit) <= SLOPE_TOLERANCE) {
                wrong.push(format!("{method}: {fit:?}, not {expected}"));
            }
        }
        for point in &curve.points {
            let (knob, work, rms) = (point.knob, point.work, point.rms);
            lines.push(format!("{method:24} {knob:>12} {work:>14} {rms:>9.1e}"));
        }
    }
    let name = experiment.name;
    assert!(lines.len() > 1, "{name} has no points");
    assert!(wrong.is_empty(), "{name}: {}", wrong.join("; "));
    lines.join("\n")
}

#[cfg(test)]
mod tests;
