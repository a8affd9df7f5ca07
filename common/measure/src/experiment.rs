//! Error against work: the price of a smaller error.
//!
//! As in work-precision diagrams of solvers of differential equations, several
//! methods solve one problem with a parameter that goes from coarse to fine. Each
//! value is a point of the diagram: the error, and its price. The price is counted,
//! which is the same on every machine, and timed, which is not.

use std::fmt;
use std::hint::black_box;
use std::ops::RangeInclusive;
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
    pub(crate) about: &'a str,
    pub(crate) knob: &'a str,
    pub(crate) work: &'a str,
    pub(crate) error: &'a str,
    pub(crate) unit: Unit<'a>,
    pub(crate) exact: &'a str,
    pub(crate) seeds: &'a [u64],
    pub(crate) against: Axis,
    /// Measures all methods. The first is the baseline of the times.
    pub curves: Box<dyn Fn(Effort) -> Vec<Curve<'a>> + 'a>,
}

impl<'a> Experiment<'a> {
    /// An experiment without methods, on errors of light, without random numbers.
    pub fn new(name: &'a str) -> Self {
        Self {
            name,
            about: "",
            knob: "",
            work: "",
            error: "",
            unit: Unit::Light,
            exact: "",
            seeds: &[],
            against: Axis::Work,
            curves: Box::new(|_| Vec::new()),
        }
    }

    /// Adds the question, in one line: the title of its plots.
    pub fn asking(self, about: &'a str) -> Self {
        Self { about, ..self }
    }

    /// Adds the axis that slopes are taken against; the parameter, with its unit in brackets
    /// if it has one; and the counted work, such as rays.
    pub fn over(mut self, against: Axis, knob: &'a str, work: &'a str) -> Self {
        (self.against, self.knob, self.work) = (against, knob, work);
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

    /// Adds the seeds of its random numbers.
    pub fn with_seeds(self, seeds: &'a [u64]) -> Self {
        Self { seeds, ..self }
    }

    /// Adds the measurement of all methods.
    pub fn with_curves(mut self, curves: impl Fn(Effort) -> Vec<Curve<'a>> + 'a) -> Self {
        self.curves = Box::new(curves);
        self
    }

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
    /// The slope that theory gives for log error over log work, or over the log of the
    /// parameter; and the range of that axis in which points count: below it, theory may not
    /// hold yet, and above it, rounding errors may be larger.
    pub slope: Option<(f64, (f64, f64))>,
    /// The greatest root mean square error that theory allows at these values of the
    /// parameter.
    pub bound: Option<(f64, RangeInclusive<f64>)>,
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
            bound: None,
            points: points.into_iter().collect(),
        }
    }

    /// A method for sets of tasks, each with its value of the parameter. The work is the
    /// number of tasks; `answer` does one, and `errors` are those of its answer.
    pub fn of_tasks<T: 'a, A, E: IntoIterator<Item = f64>>(
        method: &'a str,
        sets: &[(f64, Rc<[T]>)],
        answer: impl Fn(&T) -> A + Copy + 'a,
        errors: impl Fn(&T, A) -> E,
    ) -> Self {
        let points = sets.iter().map(|(knob, tasks)| {
            let all = tasks.iter().flat_map(|task| errors(task, answer(task)));
            let run = Rc::clone(tasks);
            let run = move || {
                run.iter()
                    .map(answer)
                    .for_each(|answer| drop(black_box(answer)));
            };
            Point::new(*knob, tasks.len() as f64, all, run)
        });
        Self::new(method, points)
    }

    /// Like [`of_tasks`](Self::of_tasks), with the share of wrong answers as the error.
    pub fn of_decisions<T: 'a, A, S: Into<f64>>(
        method: &'a str,
        sets: &[(f64, Rc<[T]>)],
        answer: impl Fn(&T) -> A + Copy + 'a,
        is_wrong: impl Fn(&T, A) -> S,
    ) -> Self {
        let error = |task: &T, answer| [is_wrong(task, answer).into().sqrt()];
        let mut curve = Self::of_tasks(method, sets, answer, error);
        for point in &mut curve.points {
            // The mean of the squares is the share.
            point.rms *= point.rms;
            point.max = point.rms;
        }
        curve
    }

    /// Adds a remark for the reader.
    pub fn with_remark(self, remark: &'a str) -> Self {
        Self { remark, ..self }
    }

    /// Adds the slope of theory, if there is one, and the range in which it holds.
    pub fn with_slope(self, expected: impl Into<Option<f64>>, between: (f64, f64)) -> Self {
        let slope = expected.into().map(|expected| (expected, between));
        Self { slope, ..self }
    }

    /// Adds the greatest error that theory allows, and the range of the parameter for it.
    pub fn with_bound(self, bound: f64, between: RangeInclusive<f64>) -> Self {
        let bound = Some((bound, between));
        Self { bound, ..self }
    }
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
    /// The work itself, to be timed, without the measurement of the error.
    pub run: Box<dyn FnMut() + 'a>,
}

impl<'a> Point<'a> {
    /// A measurement with these errors, at least one. The result of `run` counts as used,
    /// so that the compiler cannot remove the work.
    pub fn new<R>(
        knob: f64,
        work: f64,
        errors: impl IntoIterator<Item = f64>,
        mut run: impl FnMut() -> R + 'a,
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
            run: Box::new(move || drop(black_box(run()))),
        }
    }

    /// A method's own estimate of its error. It is shown beside the errors, and not
    /// compared with them.
    pub fn estimate<R>(knob: f64, work: f64, error: f64, run: impl FnMut() -> R + 'a) -> Self {
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
        for Point { knob, rms, .. } in &curve.points {
            let bound = curve.bound.as_ref();
            let bound = bound.filter(|(_, range)| range.contains(knob));
            if bound.is_some_and(|(most, _)| rms.is_nan() || rms > most) {
                wrong.push(format!("{} at {knob}: {rms:e}", curve.method));
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
