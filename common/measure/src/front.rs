//! The front: the methods that no other beats in error and time.

use common::Median;

use crate::experiment::{Axis, Curve, Experiment, Unit};
use crate::report::{Measured, duration};

impl Measured<'_, '_> {
    /// The points of a curve that can be compared with those of others, with their errors: for
    /// errors against work, all; else those of the greatest parameter, the hardest problem. A rule
    /// for decisions must be right for all parameters, so that its greatest fraction of errors counts.
    pub(crate) fn compared(&self, curve: &Curve) -> Vec<(usize, f64)> {
        let parameters = self.curves.iter().flat_map(|curve| &curve.points);
        let hardest = parameters
            .map(|point| point.parameter)
            .fold(f64::MIN, f64::max);
        let greatest = curve
            .points
            .iter()
            .map(|point| point.rms)
            .fold(0.0, f64::max);
        let Experiment { against, unit, .. } = *self.experiment;
        let points = curve.points.iter().enumerate();
        let points = points.filter(|(_, p)| against == Axis::Work || p.parameter == hardest);
        let error = |rms| if unit == Unit::Share { greatest } else { rms };
        points.map(|(p, point)| (p, error(point.rms))).collect()
    }

    /// The method, error and time of the points of which no other has both a smaller error and,
    /// beyond noise, a shorter time, from fast to slow; none of an experiment of problems.
    pub(crate) fn front(&self) -> Vec<(&str, f64, Median)> {
        let mut all = Vec::new();
        let methods = self.curves.iter().enumerate();
        for (c, curve) in methods.filter(|_| !self.experiment.of_problems) {
            let points = self.compared(curve).into_iter();
            all.extend(points.map(|(p, error)| (curve.method, error, self.time(c, p))));
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

    /// A row of a Markdown table, unless it compares problems: experiment, question, and front.
    pub fn row(&self) -> Option<String> {
        let e = self.experiment;
        let row = || format!("| `{}` | {} | {} |", e.name, e.about, self.unbeaten());
        (!e.of_problems).then(row)
    }
}
