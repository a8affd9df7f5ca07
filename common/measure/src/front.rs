//! The front: the methods that no other beats in error and time.
//!
//! Error and time have intervals, and unless the intervals of two methods are apart by a factor, there is
//! a tie. Of two methods with equal times the more exact one beats the other,
//! and of two with equal errors the faster one.

use common::Median;

use crate::experiment::{Axis, Curve, Curves, Interval, Point, Unit};
use crate::report::Measured;

/// The factor between two times up to which they count as equal: they differ by as much between
/// builds, and beside other work.
pub(crate) const EQUAL_TIMES: f64 = 1.2;

/// The factor between two errors up to which they count as equal: half a digit of a binary number.
const EQUAL_ERRORS: f64 = std::f64::consts::SQRT_2;

/// The error of a fraction, or of a decision, that is wrong in every case.
const ALL_WRONG: f64 = 1.0;

/// A point of a curve, to be compared with those of other methods.
#[derive(Clone, Copy)]
pub struct Contender {
    /// The number of its curve.
    pub curve: usize,
    /// The value of the parameter.
    pub parameter: f64,
    error: f64,
    interval: Interval,
    time: Median,
}

impl Contender {
    fn new(curve: usize, point: &Point) -> Self {
        Self {
            curve,
            parameter: point.parameter,
            error: point.errors.rms,
            interval: point.errors.interval,
            time: point.times.compared(),
        }
    }

    /// A curve of decisions: its greatest fraction of wrong ones, and its time at the last value of
    /// the parameter.
    fn as_a_rule(c: usize, curve: &Curve, opposite: Option<&Measured>) -> Option<Self> {
        let mut rule = Self::new(c, curve.points.last()?);
        let also = opposite.and_then(|other| other.curve(curve.method));
        let also = also.iter().flat_map(|other| &other.points);
        for point in curve.points.iter().chain(also) {
            if point.errors.rms > rule.error {
                rule.error = point.errors.rms;
                rule.interval = point.errors.interval;
            }
        }
        Some(rule)
    }

    fn is_faster(&self, other: &Self) -> bool {
        EQUAL_TIMES * self.time.high < other.time.low
    }

    fn is_more_exact(&self, other: &Self) -> bool {
        self.interval.high < other.interval.low && EQUAL_ERRORS * self.error < other.error
    }

    /// Whether it is better in time or in error, and not worse in the other one.
    fn beats(&self, other: &Self) -> bool {
        self.is_faster(other) && !other.is_more_exact(self)
            || self.is_more_exact(other) && !other.is_faster(self)
    }
}

impl Measured<'_> {
    /// The points that no other beats. Errors against work are one competition, and each problem is one
    /// of its own. A rule for decisions must be right for all problems, so that its greatest fraction of
    /// errors counts. Empty for an experiment of problems.
    ///
    /// `opposite` is the experiment with the opposite mistake, if there is one: the
    /// greater fraction of both counts.
    pub fn front(&self, opposite: Option<&Self>) -> Vec<Contender> {
        let e = &self.experiment;
        let mut all = Vec::new();
        match (e.curves_are, e.unit) {
            (Curves::Problems, _) => {}
            (Curves::Methods, Unit::Fraction) => {
                for (c, curve) in self.curves.iter().enumerate() {
                    all.extend(Contender::as_a_rule(c, curve, opposite));
                }
                return unbeaten(&all, e.unit);
            }
            (Curves::Methods, _) => {
                all.extend(
                    self.points()
                        .map(|(curve, point)| Contender::new(curve, point)),
                );
            }
        }
        if e.against == Axis::Work {
            return unbeaten(&all, e.unit);
        }
        let mut front = Vec::new();
        for parameter in self.parameters() {
            let mut of_problem = all.clone();
            of_problem.retain(|one| one.parameter == parameter);
            front.extend(unbeaten(&of_problem, e.unit));
        }
        front
    }
}

/// The contenders that no other one beats, of those that are timed and not wrong in every case.
fn unbeaten(contenders: &[Contender], unit: Unit) -> Vec<Contender> {
    let has_limit = matches!(unit, Unit::Fraction | Unit::FractionOf(_));
    let mut useful = contenders.to_vec();
    useful.retain(|one| {
        let is_measured = one.error.is_finite() && one.time.value.is_finite();
        is_measured && !(has_limit && one.error >= ALL_WRONG)
    });
    let mut unbeaten = useful.clone();
    unbeaten.retain(|one| !useful.iter().any(|other| other.beats(one)));
    unbeaten
}
