//! `Point`: one measurement, its errors and its times.

use std::hint::black_box;

use common::Median;

use crate::experiment::Axis;
use crate::interval::{self, Interval};

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
    /// The interval that holds the root mean square error of all inputs with 95 %.
    pub interval: Interval,
    /// The greatest error, in the same unit; none of decisions.
    pub max: Option<f64>,
    /// The number of inputs, such as tasks or pixels.
    pub inputs: usize,
}

impl Errors {
    /// The sum of these errors, of which there is at least one: one for each input.
    pub fn of(errors: impl IntoIterator<Item = f64>) -> Self {
        Self::of_inputs(1, errors)
    }

    /// The same with this number of errors for each input, side by side, such as the three channels
    /// of a pixel.
    pub fn of_inputs(errors_per_input: usize, errors: impl IntoIterator<Item = f64>) -> Self {
        let all: Vec<f64> = errors.into_iter().collect();
        let squares = all.iter().map(|error| error * error);
        Self {
            rms: (squares.sum::<f64>() / all.len() as f64).sqrt(),
            interval: interval::of_rms(&all, errors_per_input),
            max: all.iter().map(|error| error.abs()).max_by(f64::total_cmp),
            inputs: all.len() / errors_per_input,
        }
    }

    /// A fraction of wrong results, from 0 to 1, of this number of decisions. It is one error and no
    /// distribution of them.
    pub fn fraction(fraction: f64, decisions: usize) -> Self {
        Self {
            rms: fraction,
            interval: interval::of_fraction(fraction, decisions),
            max: None,
            inputs: decisions,
        }
    }

    /// The errors without those of the values that they are differences from, which are independent
    /// of them and have this root mean square.
    pub fn without(mut self, of_the_reference: f64) -> Self {
        let without = |error: f64| {
            let squares = error * error - of_the_reference * of_the_reference;
            squares.max(0.0).sqrt()
        };
        self.rms = without(self.rms);
        self.interval = Interval {
            low: without(self.interval.low),
            high: without(self.interval.high),
        };
        self
    }
}

/// The run of a measurement, without the computation of its errors, and the time it took.
pub struct Times<'a> {
    run: Box<dyn FnMut() + 'a>,
    /// The processor time of a run in seconds; NaN before it is measured.
    pub seconds: Median,
    /// The median of the quotients of the rounds: of this time, and that of the first method at the
    /// same value of the parameter; none of the first method.
    pub over_first: Option<Median>,
}

impl<'a> Times<'a> {
    /// A run that is still to be timed. Its result counts as used, so that the compiler cannot
    /// remove the work.
    pub fn of<R>(mut run: impl FnMut() -> R + 'a) -> Self {
        Self {
            run: Box::new(move || drop(black_box(run()))),
            seconds: Median::of(Vec::new()),
            over_first: None,
        }
    }

    /// The processor time of this number of runs, in seconds.
    pub(crate) fn measure(&mut self, runs: u32) -> f64 {
        let start = now();
        self.run(runs);
        now() - start
    }

    /// Runs it this number of times.
    pub(crate) fn run(&mut self, runs: u32) {
        for _ in 0..runs {
            (self.run)();
        }
    }

    /// The time as it is compared with those of other methods at the same value of the parameter:
    /// what disturbs both alike is no part of its interval.
    pub(crate) fn compared(&self) -> Median {
        match self.over_first {
            Some(_) => self.seconds,
            None => Median {
                low: self.seconds.value,
                high: self.seconds.value,
                ..self.seconds
            },
        }
    }
}

/// The time that this program has worked, in seconds: waiting while others have the processor does not count.
#[cfg(not(target_family = "wasm"))]
fn now() -> f64 {
    command_line::processor_time()
}

/// In browsers the page has the clock.
#[cfg(target_family = "wasm")]
fn now() -> f64 {
    f64::NAN
}
