//! `Point`: one measurement, its errors and its times.

use std::hint::black_box;
use std::time::Instant;

use common::Median;

use crate::deviation::{Deviation, Problem, rms};
use crate::experiment::Axis;

/// One measurement of a method.
pub struct Point<'a> {
    /// The value of the parameter.
    pub parameter: f64,
    /// The counted work.
    pub work: f64,
    /// The errors of the results.
    pub errors: Errors,
    /// The run that gives the results, and how long it takes.
    pub times: Times<'a>,
}

impl Point<'_> {
    /// The coordinate on an axis.
    pub const fn on(&self, axis: Axis) -> f64 {
        match axis {
            Axis::Work => self.work,
            Axis::Parameter => self.parameter,
        }
    }
}

/// The errors of a measurement, summed up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    /// The root mean square error, in the unit of the experiment.
    pub rms: f64,
    /// The least error that 99 of a hundred do not exceed: in units in the last place of the
    /// exact value, if these are known; otherwise in the unit of the experiment.
    pub p99: f64,
    /// The greatest error, in the same unit as [`p99`](Self::p99).
    pub max: f64,
    /// The errors that the problem itself has, if its condition is known.
    pub problem: Option<Problem>,
}

impl Errors {
    /// The sum of these errors, of which there is at least one.
    pub fn of(errors: impl IntoIterator<Item: Into<Deviation>>) -> Self {
        let all: Vec<Deviation> = errors.into_iter().map(Into::into).collect();
        let mut sizes: Vec<f64> = all.iter().map(Deviation::size).collect();
        sizes.sort_by(f64::total_cmp);
        let rank_of_p99 = (0.99 * sizes.len() as f64).ceil() as usize;
        let p99 = sizes.get(rank_of_p99.saturating_sub(1));
        Self {
            rms: rms(all.iter().map(|one| one.error)),
            p99: p99.copied().unwrap_or(f64::NAN),
            max: sizes.last().copied().unwrap_or(f64::NAN),
            problem: Problem::of(&all),
        }
    }

    /// A fraction of wrong results, from 0 to 1, which is one error and no distribution of them.
    pub const fn fraction(fraction: f64) -> Self {
        Self {
            rms: fraction,
            p99: fraction,
            max: fraction,
            problem: None,
        }
    }
}

/// The run of a measurement, without the computation of its errors, and the times it took.
pub struct Times<'a> {
    run: Box<dyn FnMut() + 'a>,
    /// One time for each round, in seconds; none before the first.
    pub seconds: Vec<f64>,
}

impl<'a> Times<'a> {
    /// A run that is still to be timed. Its result counts as used, so that the compiler cannot
    /// remove the work.
    pub fn of<R>(mut run: impl FnMut() -> R + 'a) -> Self {
        Self {
            run: Box::new(move || drop(black_box(run()))),
            seconds: Vec::new(),
        }
    }

    /// Runs once more, and adds the time.
    pub fn measure(&mut self) {
        let start = Instant::now();
        (self.run)();
        self.seconds.push(start.elapsed().as_secs_f64());
    }

    /// The median of the times, in seconds.
    pub fn median(&self) -> Median {
        Median::of(self.seconds.clone())
    }
}
