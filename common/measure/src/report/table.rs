//! The table of a measured experiment for the terminal, and the slopes below it.

use std::fmt::Write;
use std::time::Duration;

use common::{Median, text};

use crate::experiment::{Curve, Curves, Errors, Interval};
use crate::front::Contender;
use crate::report::Measured;
use crate::rounded_interval::mantissa;

impl Measured<'_> {
    /// The table for the terminal. `opposite` is the experiment with the opposite mistake, without
    /// which an experiment that has one has no front.
    pub fn table(&self, opposite: Option<&Self>) -> String {
        let e = &self.experiment;
        let (name, question, unit, exact) = (e.name, e.question, e.unit, e.exact);
        let mut text = format!("{name}: {question}\n");
        let _ = writeln!(text, "  {} ({unit}), {exact}", e.error);
        let _ = writeln!(
            text,
            "  ± is half of the interval of 95 %, which for a time holds in this run{}",
            self.beyond_max()
        );
        let has_front = e.opposite.is_none() || opposite.is_some();
        let front = if has_front {
            self.front(opposite)
        } else {
            Vec::new()
        };
        self.add_rows(&mut text, &front);
        for curve in &self.curves {
            if let Some(slope) = self.slope(curve) {
                let _ = writeln!(text, "  {}: {slope}", curve.method);
            }
        }
        if e.curves_are == Curves::Methods {
            let front = match e.opposite {
                Some(name) if !has_front => format!("see report {} {name}", e.name),
                _ => self.names_of(&front),
            };
            let _ = writeln!(
                text,
                "  Pareto front of error and time, on this machine: {front}"
            );
        }
        text
    }

    /// What the greatest error says about inputs that nobody measured. If a fraction p of all inputs had a greater
    /// error, then n of them would all miss it with the probability (1 - p)^n, which is 5 % for the printed p.
    fn beyond_max(&self) -> String {
        let points = self
            .points()
            .filter(|(_, point)| point.errors.max.is_some());
        let Some(inputs) = points.map(|(_, point)| point.errors.inputs).min() else {
            return String::new();
        };
        let percent = 100.0 * (1.0 - libm::pow(0.05, 1.0 / inputs as f64));
        format!(
            "; max is of {inputs} inputs: with 95 %, at most {} % of all inputs have a greater error",
            text::rounded(percent, 2)
        )
    }

    /// The methods on a front.
    pub(super) fn names_of(&self, front: &[Contender]) -> String {
        let mut names = Vec::new();
        for (c, curve) in self.curves.iter().enumerate() {
            if front.iter().any(|one| one.curve == c) {
                names.push(curve.method);
            }
        }
        names.join(", ")
    }

    /// The head of the table and a row for each point. A star marks the points of the front.
    fn add_rows(&self, text: &mut String, front: &[Contender]) {
        let e = &self.experiment;
        let parameter_width = e.parameter.chars().count().max(12);
        let work_width = e.work.chars().count().max(14);
        let _ = writeln!(
            text,
            "  {:24} {:>parameter_width$} {:>work_width$}             error       max             time  time / first method",
            "method", e.parameter, e.work
        );
        for (c, curve) in self.curves.iter().enumerate() {
            for point in &curve.points {
                let is_point = |one: &Contender| one.curve == c && one.parameter == point.parameter;
                let star = if front.iter().any(is_point) { "*" } else { " " };
                let [parameter, work] = [point.parameter, point.work].map(short);
                let _ = write!(
                    text,
                    "{star} {:24} {parameter:>parameter_width$} {work:>work_width$}",
                    curve.method
                );
                let errors = &point.errors;
                let max = match errors.max {
                    Some(error) => format!("{error:.1e}"),
                    None => String::new(),
                };
                let error = error(errors);
                let time = time(&point.times.seconds);
                let _ = write!(text, " {error:>17} {max:>9} {time:>16}");
                if let Some(quotient) = point.times.over_first {
                    let _ = write!(text, "  {quotient}");
                }
                text.push('\n');
            }
        }
    }

    /// The slope of a curve, or why it has none.
    fn slope(&self, curve: &Curve) -> Option<String> {
        let fit = self.experiment.fit(curve)?;
        let theory = match &curve.slope {
            Some(slope) => format!(" (theory {})", slope.value),
            None => String::new(),
        };
        Some(format!("{fit}{theory}"))
    }
}

/// A number in few characters.
fn short(number: f64) -> String {
    text::rounded(number, 5)
}

/// An error with its interval.
fn error(errors: &Errors) -> String {
    let Interval { low, high } = errors.interval;
    match mantissa(errors.rms, low, high) {
        (sure, 0) => sure.to_string(),
        (sure, power) => format!("({sure})e{power}"),
    }
}

/// A time with its interval in percent.
fn time(Median { low, value, high }: &Median) -> String {
    let percent = 100.0 * (high - value).max(value - low) / value;
    format!("{} ± {:.0} %", duration(*value), percent.ceil())
}

/// A time, in the unit in which it has few digits.
pub(super) fn duration(seconds: f64) -> String {
    let duration = Duration::try_from_secs_f64(seconds).unwrap_or_default();
    format!("{duration:.1?}")
}
