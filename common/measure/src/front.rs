//! The front: the methods that no other beats in error and time.

use common::Median;

use crate::experiment::{Axis, Curve, Curves, Unit};
use crate::report::{Measured, duration};

/// A point of a curve, to be compared with those of other methods.
#[derive(Clone, Copy)]
pub(crate) struct Contender<'a> {
    pub method: &'a str,
    pub error: f64,
    pub time: Median,
}

impl Contender<'_> {
    /// Whether another contender is no better in error, and slower beyond noise; or worse in error
    /// and no faster.
    fn beats(&self, other: &Self) -> bool {
        let is_faster = self.time.high < other.time.low;
        let is_no_slower = self.time.value <= other.time.value;
        self.error <= other.error && is_faster || self.error < other.error && is_no_slower
    }
}

impl<'a> Measured<'_, 'a> {
    /// The points of a curve that can be compared with those of others: for errors against work,
    /// all; else those of the greatest parameter, the hardest problem. A rule for decisions must be
    /// right for all parameters, so that its greatest fraction of errors counts.
    pub(crate) fn contenders(&self, curve: &Curve<'a>) -> Vec<Contender<'a>> {
        let greatest_fraction = curve
            .points
            .iter()
            .fold(0.0, |greatest, point| f64::max(greatest, point.errors.rms));
        let hardest = self.greatest_parameter();
        let mut contenders = Vec::new();
        for point in &curve.points {
            if self.experiment.against == Axis::Parameter && point.parameter != hardest {
                continue;
            }
            contenders.push(Contender {
                method: curve.method,
                error: match self.experiment.unit {
                    Unit::Fraction => greatest_fraction,
                    _ => point.errors.rms,
                },
                time: point.times.median(),
            });
        }
        contenders
    }

    fn greatest_parameter(&self) -> f64 {
        let mut greatest = f64::MIN;
        for curve in &self.curves {
            for point in &curve.points {
                greatest = greatest.max(point.parameter);
            }
        }
        greatest
    }

    /// The contenders of which no other has both a smaller error and, beyond noise, a shorter
    /// time, from fast to slow; none of an experiment of problems.
    pub(crate) fn front(&self) -> Vec<Contender<'a>> {
        if self.experiment.curves_are == Curves::Problems {
            return Vec::new();
        }
        let mut all = Vec::new();
        for curve in &self.curves {
            all.extend(self.contenders(curve));
        }
        let is_unbeaten = |one: &&Contender| !all.iter().any(|other| other.beats(one));
        let mut front: Vec<_> = all.iter().filter(is_unbeaten).copied().collect();
        front.sort_by(|a, b| a.time.value.total_cmp(&b.time.value));
        front
    }

    /// The front in words: each of its methods, with its errors and times.
    pub(crate) fn unbeaten(&self) -> String {
        let front = self.front();
        let mut methods = Vec::new();
        for curve in &self.curves {
            let of_method = front.iter().filter(|one| one.method == curve.method);
            let points: Vec<_> = of_method
                .map(|one| format!("{:.1e} in {}", one.error, duration(one.time.value)))
                .collect();
            let range = match &points[..] {
                [] => continue,
                [only] => only.clone(),
                [fastest, .., slowest] => format!("{fastest} to {slowest}"),
            };
            methods.push(format!("{} ({range})", curve.method));
        }
        methods.join(", ")
    }

    /// A row of a Markdown table, unless it compares problems: experiment, question, and front.
    pub fn row(&self) -> Option<String> {
        let e = self.experiment;
        if e.curves_are == Curves::Problems {
            return None;
        }
        let unbeaten = self.unbeaten();
        Some(format!("| `{}` | {} | {unbeaten} |", e.name, e.question))
    }
}
