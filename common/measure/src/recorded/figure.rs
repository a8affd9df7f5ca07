//! Figures of points, as pages print them, and the names of these points.

use common::Median;

use super::RecordedPoint;
use super::recorded_point::Measurement;
use crate::rounded_interval::{RoundedInterval, mantissa};

/// The name of one or two methods, such as `a04.sphere-far.stable-ours/protocol@512`.
pub struct Name<'n> {
    pub experiment: &'n str,
    pub methods: &'n str,
    /// A value of the parameter.
    pub at: Option<f64>,
}

impl<'n> Name<'n> {
    pub fn parse(name: &'n str) -> Option<Self> {
        let (name, at) = match name.split_once('@') {
            Some((name, at)) => (name, Some(at.parse().ok()?)),
            None => (name, None),
        };
        let (experiment, methods) = name.rsplit_once('.')?;
        Some(Self {
            experiment,
            methods,
            at,
        })
    }
}

/// A quotient of times. Where its interval holds 1, words say so.
pub fn quotient(quotient: Measurement) -> String {
    match noise(quotient) {
        Some(noise) => format!("no difference (within {noise})"),
        None => rounded(quotient),
    }
}

/// The same behind "takes", with the quotient elsewhere if that has another sign.
pub fn times_as_long(here: Measurement, elsewhere: Option<Measurement>) -> String {
    let words = |quotient| match noise(quotient) {
        Some(noise) => format!("as long, within {noise}"),
        None => format!("{} times as long", rounded(quotient)),
    };
    match elsewhere {
        Some(elsewhere) => format!("{} here, and {} elsewhere", words(here), words(elsewhere)),
        None => words(here),
    }
}

fn noise(Measurement { value, low, high }: Measurement) -> Option<String> {
    Median { low, value, high }.noise()
}

fn rounded(Measurement { value, low, high }: Measurement) -> String {
    RoundedInterval::within(value, low, high)
        .to_string()
        .replace('-', "−")
}

/// An error, in percent if it is a fraction of decisions.
pub fn error(point: &RecordedPoint) -> String {
    let error = point.error;
    if point.unit == "all = 1" {
        let percent = error.over(0.01);
        return match error.value {
            0.0 => format!(
                "below {} %",
                RoundedInterval::around(0.0, percent.high).half()
            ),
            1.0 => "all".to_owned(),
            _ => format!("{} %", rounded(percent)),
        };
    }
    let (mantissa, power) = mantissa(error.value, error.low, error.high);
    if (-4..6).contains(&power) {
        rounded(error)
    } else {
        // In the notation of the book's formulas.
        let mantissa = mantissa.to_string().replace('±', r"\pm");
        format!(r"$({mantissa}) \cdot 10^{{{power}}}$")
    }
}

/// A slope.
pub fn slope(point: &RecordedPoint) -> String {
    point
        .slope
        .map_or_else(|| "no power law".to_owned(), rounded)
}
