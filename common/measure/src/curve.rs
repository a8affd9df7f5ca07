//! `Curve`: the measurements of one method.

use std::hint::black_box;
use std::ops::RangeInclusive;
use std::rc::Rc;

use crate::point::{Errors, Point, Times};

/// A method at all values of the parameter.
///
/// What theory says about it stands in a literal over the measurement:
/// `Curve { slope: Some(…), ..Curve::of_tasks(…) }`.
pub struct Curve<'a> {
    /// The name of the method.
    pub method: &'a str,
    /// The slope that theory gives.
    pub slope: Option<Slope>,
    /// The greatest error that theory allows.
    pub bound: Option<ErrorBound>,
    /// The measurements, from coarse to fine.
    pub points: Vec<Point<'a>>,
}

/// The slope of log error over log work, or over the log of the parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Slope {
    /// The slope: -0.5 for an error that falls as one over the square root.
    pub value: f64,
    /// The range of work or parameter in which points count: below it, theory may not hold yet,
    /// and above it, rounding errors may be larger.
    pub between: RangeInclusive<f64>,
}

/// The greatest root mean square error that theory allows.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorBound {
    /// The error.
    pub error: f64,
    /// The values of the parameter for which it is promised.
    pub between: RangeInclusive<f64>,
}

/// Tasks of the same difficulty, which all methods do.
pub struct TaskSet<T> {
    /// The value of the parameter.
    pub parameter: f64,
    /// The tasks, shared by the methods.
    pub tasks: Rc<[T]>,
}

impl<'a> Curve<'a> {
    /// A method about which theory says nothing.
    pub fn new(method: &'a str, points: impl IntoIterator<Item = Point<'a>>) -> Self {
        Self {
            method,
            slope: None,
            bound: None,
            points: points.into_iter().collect(),
        }
    }

    /// A method for sets of tasks. The work is the number of tasks; `answer` does one of them, and
    /// `errors` are those of its answer.
    pub fn of_tasks<T: 'a, A, E: IntoIterator<Item = f64>>(
        method: &'a str,
        sets: &[TaskSet<T>],
        answer: impl Fn(&T) -> A + Copy + 'a,
        errors: impl Fn(&T, A) -> E,
    ) -> Self {
        Self::of_sets(method, sets, answer, |tasks| {
            let mut all = Vec::new();
            let mut errors_per_task = 1;
            for task in tasks {
                let before = all.len();
                all.extend(errors(task, answer(task)));
                errors_per_task = errors_per_task.max(all.len() - before);
            }
            Errors::of_inputs(errors_per_task, all)
        })
    }

    /// Like [`of_tasks`](Self::of_tasks), with the fraction of wrong answers as the error.
    /// `wrong` says how much of an answer is wrong: whether it is, or a number from 0 to 1.
    pub fn of_decisions<T: 'a, A, S: Into<f64>>(
        method: &'a str,
        sets: &[TaskSet<T>],
        answer: impl Fn(&T) -> A + Copy + 'a,
        wrong: impl Fn(&T, A) -> S,
    ) -> Self {
        Self::of_sets(method, sets, answer, |tasks| {
            let mut sum = 0.0;
            for task in tasks {
                sum += wrong(task, answer(task)).into();
            }
            Errors::fraction(sum / tasks.len() as f64, tasks.len())
        })
    }

    /// A point for each set: the errors of its answers, and a run that gives all answers.
    fn of_sets<T: 'a, A>(
        method: &'a str,
        sets: &[TaskSet<T>],
        answer: impl Fn(&T) -> A + Copy + 'a,
        errors_of: impl Fn(&[T]) -> Errors,
    ) -> Self {
        let mut points = Vec::new();
        for TaskSet { parameter, tasks } in sets {
            let run = Rc::clone(tasks);
            points.push(Point {
                parameter: *parameter,
                work: tasks.len() as f64,
                errors: errors_of(tasks),
                times: Times::of(move || {
                    for task in run.iter() {
                        black_box(answer(black_box(task)));
                    }
                }),
            });
        }
        Self::new(method, points)
    }
}
