//! The front: the methods that no other beats in error and time.

use crate::curve::Point;
use crate::experiment::{Axis, Unit};
use crate::report::{Measured, duration};
use crate::timing::Median;

impl Measured<'_, '_> {
    /// Whether the errors of points can be compared: for errors against work, all; else those of
    /// the greatest parameter, the hardest problem.
    pub(crate) fn is_compared(&self, point: &Point) -> bool {
        let knobs = self.curves.iter().flat_map(|curve| &curve.points);
        let greatest = knobs.map(|point| point.knob).fold(f64::MIN, f64::max);
        self.experiment.against == Axis::Work || point.knob == greatest
    }

    /// The method, error and time of the points of which no other has both a smaller error and,
    /// beyond noise, a shorter time, from fast to slow.
    pub(crate) fn front(&self) -> Vec<(&str, f64, Median)> {
        let mut all = Vec::new();
        for (c, curve) in self.curves.iter().enumerate() {
            // A rule for decisions must be right for all parameters.
            let of_all = curve
                .points
                .iter()
                .map(|point| point.rms)
                .fold(0.0, f64::max);
            for (p, point) in curve.points.iter().enumerate() {
                let is_share = self.experiment.unit == Unit::Share;
                let error = if is_share { of_all } else { point.rms };
                if self.is_compared(point) {
                    all.push((curve.method, error, self.time(c, p)));
                }
            }
        }
        let beats = |(_, error, time): &(_, f64, Median), (_, other, slower): &(_, f64, Median)| {
            error <= other && time.high < slower.low || error < other && time.value <= slower.value
        };
        let is_unbeaten = |one: &&_| !all.iter().any(|other| beats(other, one));
        let mut front: Vec<_> = all.iter().filter(is_unbeaten).copied().collect();
        front.sort_by(|a, b| a.2.value.total_cmp(&b.2.value));
        front
    }

    /// The front in words: each of its methods, with its errors and times.
    pub(crate) fn unbeaten(&self) -> String {
        let front = self.front();
        let range = |of: &str| {
            let mut points = front.iter().filter(|(method, ..)| *method == of);
            let point = |(_, error, time): &(_, f64, Median)| {
                format!("{error:.1e} in {}", duration(time.value))
            };
            let ends = [points.next(), points.next_back()].into_iter().flatten();
            format!(
                "{of} ({})",
                ends.map(point).collect::<Vec<_>>().join(" to ")
            )
        };
        let is_in = |method: &&str| front.iter().any(|(one, ..)| one == method);
        let methods = self.curves.iter().map(|curve| curve.method).filter(is_in);
        methods.map(range).collect::<Vec<_>>().join(", ")
    }

    /// A row of a Markdown table: experiment, question, and front.
    pub fn row(&self) -> String {
        let e = self.experiment;
        format!("| `{}` | {} | {} |", e.name, e.about, self.unbeaten())
    }
}
