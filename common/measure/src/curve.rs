//! `Curve`: the measurements of one method.

use std::hint::black_box;
use std::ops::RangeInclusive;
use std::rc::Rc;

use crate::deviation::{Deviation, Problem, rms};
use crate::experiment::Axis;
use crate::report::compact;

/// A method at all values of the parameter.
pub struct Curve<'a> {
    /// Its name.
    pub method: &'a str,
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
    /// A method without a slope in theory.
    pub fn new(method: &'a str, points: impl IntoIterator<Item = Point<'a>>) -> Self {
        Self {
            method,
            slope: None,
            bound: None,
            points: points.into_iter().collect(),
        }
    }

    /// A method for sets of tasks, each with its value of the parameter. The work is the
    /// number of tasks; `answer` does one, and `errors` are those of its answer.
    pub fn of_tasks<T: 'a, A, E: IntoIterator<Item: Into<Deviation>>>(
        method: &'a str,
        sets: &[(f64, Rc<[T]>)],
        answer: impl Fn(&T) -> A + Copy + 'a,
        errors: impl Fn(&T, A) -> E,
    ) -> Self {
        let points = sets.iter().map(|(parameter, tasks)| {
            let all = tasks.iter().flat_map(|task| errors(task, answer(task)));
            let run = Rc::clone(tasks);
            let run = move || {
                run.iter()
                    .map(answer)
                    .for_each(|answer| drop(black_box(answer)));
            };
            Point::new(*parameter, tasks.len() as f64, all, run)
        });
        Self::new(method, points)
    }

    /// Like [`of_tasks`](Self::of_tasks), with the fraction of wrong answers as the error.
    pub fn of_decisions<T: 'a, A, S: Into<f64>>(
        method: &'a str,
        sets: &[(f64, Rc<[T]>)],
        answer: impl Fn(&T) -> A + Copy + 'a,
        is_wrong: impl Fn(&T, A) -> S,
    ) -> Self {
        let error = |task: &T, answer| [is_wrong(task, answer).into().sqrt()];
        let mut curve = Self::of_tasks(method, sets, answer, error);
        for point in &mut curve.points {
            // The mean of the squares is the fraction.
            point.rms *= point.rms;
            (point.p99, point.max) = (point.rms, point.rms);
        }
        curve
    }

    /// Whether the problem or the formula is to blame for the errors, where conditions are
    /// known. Beyond ten times the errors of the problem, the formula is; and below a tenth of
    /// those of the hardest problem, neither is.
    pub(crate) fn blame(&self) -> Option<String> {
        let greatest = |of: fn(&Problem) -> f64| {
            let known = self.points.iter();
            let known = known.filter_map(|p| Some((p.parameter, p.problem?)));
            known.max_by(|(_, a), (_, b)| of(a).total_cmp(&of(b)))
        };
        let (parameter, worst) = greatest(|problem| problem.fault)?;
        let (last, hardest) = greatest(|problem| problem.condition)?;
        let unit = "times condition · ulp";
        let (worst, hardest) = (worst.fault, hardest.fault);
        Some(if worst > 10.0 {
            let parameter = compact(parameter);
            format!("up to {worst:.0e} {unit}, at {parameter}: the formula is to blame")
        } else if hardest < 0.1 {
            let parameter = compact(last);
            format!("{hardest:.0e} {unit} at {parameter}, the hardest: neither is to blame")
        } else {
            format!("at most {worst:.2} {unit}: the problem is to blame")
        })
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

/// One measurement.
pub struct Point<'a> {
    /// The value of the parameter.
    pub parameter: f64,
    /// The counted work.
    pub work: f64,
    /// The root mean square error.
    pub rms: f64,
    /// The least error that 99 of a hundred do not exceed, and the greatest: in units in the
    /// last place of the exact value, if these are known.
    pub p99: f64,
    /// The greatest error.
    pub max: f64,
    /// The errors beside those that the problem itself has, if its condition is known.
    pub problem: Option<Problem>,
    /// The work itself, to be timed, without the measurement of the error.
    pub run: Box<dyn FnMut() + 'a>,
}

impl<'a> Point<'a> {
    /// A measurement with these errors, at least one. The result of `run` counts as used,
    /// so that the compiler cannot remove the work.
    pub fn new<R>(
        parameter: f64,
        work: f64,
        errors: impl IntoIterator<Item: Into<Deviation>>,
        mut run: impl FnMut() -> R + 'a,
    ) -> Self {
        let all: Vec<Deviation> = errors.into_iter().map(Into::into).collect();
        let mut sizes: Vec<_> = all.iter().map(Deviation::size).collect();
        sizes.sort_by(f64::total_cmp);
        let rank = |fraction: f64| (fraction * sizes.len() as f64).ceil() as usize;
        let at = |fraction| sizes.get(rank(fraction).saturating_sub(1)).copied();
        Self {
            parameter,
            work,
            rms: rms(all.iter().map(|one| one.error)),
            p99: at(0.99).unwrap_or(f64::NAN),
            max: at(1.0).unwrap_or(f64::NAN),
            problem: Problem::of(&all),
            run: Box::new(move || drop(black_box(run()))),
        }
    }

    /// The coordinate on an axis.
    pub const fn on(&self, axis: Axis) -> f64 {
        match axis {
            Axis::Work => self.work,
            Axis::Parameter => self.parameter,
        }
    }
}
