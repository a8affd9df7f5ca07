//! The table of a measured experiment for the terminal, and the remarks below it.

use std::fmt::Write;
use std::time::Duration;

use crate::experiment::{Axis, Curve, Curves, HALF_GREY_LEVEL, pareto_front};
use crate::report::Measured;

impl Measured<'_, '_> {
    /// The table for the terminal.
    pub fn table(&self) -> String {
        let e = self.experiment;
        let (name, question, unit, exact) = (e.name, e.question, e.unit, e.exact);
        let units_of_columns = if self.knows_conditions() {
            "; 99 % and max in ulp"
        } else {
            ""
        };
        let mut text = format!("{name}: {question}\n");
        let _ = writeln!(text, "  {} ({unit}), {exact}{units_of_columns}", e.error);
        self.add_rows(&mut text);
        for (c, curve) in self.curves.iter().enumerate() {
            let remarks = self.remarks(c, curve);
            if !remarks.is_empty() {
                let _ = writeln!(text, "  {}: {}", curve.method, remarks.join("; "));
            }
        }
        if e.curves_are == Curves::Methods {
            let _ = writeln!(text, "  unbeaten in error and time: {}", self.unbeaten());
        }
        text
    }

    fn knows_conditions(&self) -> bool {
        let mut points = self.curves.iter().flat_map(|curve| &curve.points);
        points.any(|point| point.errors.problem.is_some())
    }

    /// The head of the table and a row for each point. A star marks the points of the Pareto
    /// front, where there is one: against the parameter there is no price.
    fn add_rows(&self, text: &mut String) {
        let e = self.experiment;
        let parameter_width = e.parameter.chars().count().max(12);
        let work_width = e.work.chars().count().max(14);
        let _ = writeln!(
            text,
            "  {:24} {:>parameter_width$} {:>work_width$}     error      99 %       max condition       time  time / first method",
            "method", e.parameter, e.work
        );
        let front = pareto_front(&self.curves);
        let has_front = e.against == Axis::Work && e.curves_are == Curves::Methods;
        for (c, curve) in self.curves.iter().enumerate() {
            for (p, point) in curve.points.iter().enumerate() {
                let star = if has_front && front[c][p] { "*" } else { " " };
                let parameter = compact(point.parameter);
                let work = compact(point.work);
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
                let _ = write!(
                    text,
                    " {:>9.1e} {:>9.1e} {:>9.1e} {condition:>9}",
                    errors.rms, errors.p99, errors.max
                );
                let time = duration(point.times.median().value);
                let _ = write!(text, " {time:>10}");
                if let Some(quotient) = self.time_over_first(c, p) {
                    let _ = write!(text, "  {quotient}");
                }
                text.push('\n');
            }
        }
    }

    /// What the errors of a curve say: its slope, the work to reach half a grey level, whether the
    /// problem or the formula is to blame, and time and error beside the first method's.
    fn remarks(&self, c: usize, curve: &Curve) -> Vec<String> {
        let mut remarks = Vec::new();
        if let Some(fit) = self.experiment.fit(curve) {
            let theory = match &curve.slope {
                Some(slope) => format!(" (theory {})", slope.value),
                None => String::new(),
            };
            remarks.push(format!("{fit}{theory}"));
        }
        if self.experiment.can_be_seen(&self.curves)
            && let Some(reached) = curve.work_to_reach(HALF_GREY_LEVEL)
        {
            let beyond = if reached.is_extrapolated {
                ", extrapolated"
            } else {
                ""
            };
            let work = compact(libm::round(reached.work));
            let unit = self.experiment.work;
            remarks.push(format!("1/510 takes {work} {unit}{beyond}"));
        }
        remarks.extend(curve.verdict());
        remarks.extend(self.beside_first(c));
        remarks
    }

    /// The time and the error of a method at the last value of the parameter that it shares
    /// with the first, over those of the first.
    fn beside_first(&self, c: usize) -> Option<String> {
        let points = &self.curves[c].points;
        let mut shared = None;
        for p in 0..points.len() {
            if let Some(time) = self.time_over_first(c, p) {
                shared = Some((p, time));
            }
        }
        let (p, time) = shared?;
        let first = self.curves[0].points[p].errors.rms;
        let own = points[p].errors.rms;
        let error = match own / first {
            _ if own == 0.0 => "no error".to_owned(),
            ratio @ 0.01..1e4 => format!("{ratio:.2} times its error"),
            ratio if ratio.is_finite() => format!("{ratio:.1e} times its error"),
            _ => format!("an error of {own:.1e}, where it has none"),
        };
        let method = self.curves[0].method;
        let parameter = compact(points[p].parameter);
        Some(format!(
            "beside {method} at {parameter}: {error}, time {time}"
        ))
    }
}

/// A number in few characters.
pub(crate) fn compact(number: f64) -> String {
    if number == 0.0 || (1e-3..1e10).contains(&number.abs()) {
        format!("{}", libm::round(number * 1e4) / 1e4)
    } else {
        format!("{number:.2e}")
    }
}

/// A time, in the unit in which it has few digits.
pub(crate) fn duration(seconds: f64) -> String {
    let duration = Duration::try_from_secs_f64(seconds).unwrap_or_default();
    format!("{duration:.1?}")
}
