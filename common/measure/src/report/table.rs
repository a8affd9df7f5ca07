//! The table of a measured experiment for the terminal, and the remarks below it.

use std::fmt::Write;
use std::time::Duration;

use common::text;

use crate::experiment::{Curve, Curves, Point};
use crate::front::Contender;
use crate::report::Measured;

impl Measured<'_> {
    /// The table for the terminal. `opposite` is the experiment with the opposite mistake, without
    /// which an experiment that has one has no front.
    pub fn table(&self, opposite: Option<&Self>) -> String {
        let e = &self.experiment;
        let (name, question, unit, exact) = (e.name, e.question, e.unit, e.exact);
        let units_of_columns = if self.knows_conditions() {
            "; max in ulp"
        } else {
            ""
        };
        let mut text = format!("{name}: {question}\n");
        let _ = writeln!(text, "  {} ({unit}), {exact}{units_of_columns}", e.error);
        let has_front = e.opposite.is_none() || opposite.is_some();
        let front = if has_front {
            self.front(opposite)
        } else {
            Vec::new()
        };
        self.add_rows(&mut text, &front);
        for (c, curve) in self.curves.iter().enumerate() {
            let remarks = self.remarks(c, curve);
            if !remarks.is_empty() {
                let _ = writeln!(text, "  {}: {}", curve.method, remarks.join("; "));
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

    fn knows_conditions(&self) -> bool {
        let mut points = self.curves.iter().flat_map(|curve| &curve.points);
        points.any(|point| point.errors.problem.is_some())
    }

    /// The head of the table and a row for each point. A star marks the points of the front.
    fn add_rows(&self, text: &mut String, front: &[Contender]) {
        let e = &self.experiment;
        let parameter_width = e.parameter.chars().count().max(12);
        let work_width = e.work.chars().count().max(14);
        let _ = writeln!(
            text,
            "  {:24} {:>parameter_width$} {:>work_width$}     error       max condition       time  time / first method",
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
                let condition = match errors.problem {
                    Some(problem) => format!("{:.1e}", problem.condition),
                    None => String::new(),
                };
                let max = match errors.max {
                    Some(error) => format!("{error:.1e}"),
                    None => String::new(),
                };
                let _ = write!(text, " {:>9.1e} {max:>9} {condition:>9}", errors.rms);
                let time = duration(point.times.seconds.value);
                let _ = write!(text, " {time:>10}");
                if let Some(quotient) = point.times.over_first {
                    let _ = write!(text, "  {quotient}");
                }
                text.push('\n');
            }
        }
    }

    /// What the errors of a curve say: its slope, whether the problem or the formula is to blame, and
    /// time and error beside the first method's.
    fn remarks(&self, c: usize, curve: &Curve) -> Vec<String> {
        let mut remarks = Vec::new();
        if let Some(fit) = self.experiment.fit(curve) {
            let theory = match &curve.slope {
                Some(slope) => format!(" (theory {})", slope.value),
                None => String::new(),
            };
            remarks.push(format!("{fit}{theory}"));
        }
        remarks.extend(curve.verdict());
        remarks.extend(self.beside_first(c));
        remarks
    }

    /// The time and the error of a method at the last value of the parameter that it shares
    /// with the first, over those of the first.
    fn beside_first(&self, c: usize) -> Option<String> {
        let points = &self.curves[c].points;
        let has_quotient = |point: &Point| point.times.over_first.is_some();
        let p = points.iter().rposition(has_quotient)?;
        let time = points[p].times.over_first?;
        let first = self.curves[0].points[p].errors.rms;
        let own = points[p].errors.rms;
        let error = match own / first {
            _ if own == 0.0 => "no error".to_owned(),
            ratio @ 0.01..1e4 => format!("{ratio:.2} times its error"),
            ratio if ratio.is_finite() => format!("{ratio:.1e} times its error"),
            _ => format!("an error of {own:.1e}, where it has none"),
        };
        let method = self.curves[0].method;
        let parameter = short(points[p].parameter);
        Some(format!(
            "beside {method} at {parameter}: {error}, time {time}"
        ))
    }
}

/// A number in few characters.
fn short(number: f64) -> String {
    text::rounded(number, 5)
}

/// A time, in the unit in which it has few digits.
pub(super) fn duration(seconds: f64) -> String {
    let duration = Duration::try_from_secs_f64(seconds).unwrap_or_default();
    format!("{duration:.1?}")
}
