//! The verdict about an answer: right, or wrong in its decision or in its value.

use crate::{Answer, Case};

/// The relative rounding error of doubles, `2^-53`.
pub const DOUBLE: f64 = 0.5 * f64::EPSILON;

/// The relative rounding error of single precision, `2^-24`.
pub const SINGLE: f64 = 0.5 * f32::EPSILON as f64;

/// How many rounding errors of its inputs an answer may be off. A formula of some dozen operations that
/// adds no error of its own kind stays below.
const ALLOWED: f64 = 16.0;

/// The `t` that a library finds, if it finds a hit.
pub type Found = Option<f64>;

/// What is to be said of an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The decision is right, and `t` is as near as the condition lets it be.
    Right,
    /// A hit where there is none, or none where there is one.
    WrongDecision,
    /// A hit that is there, but whose `t` is off by more than 16 times the condition times the rounding
    /// error, or is no number.
    WrongValue,
    /// The answer is another one, but if each input changes by 16 of its rounding errors, the exact
    /// answer may jump, too: the ray meets a border, or starts on the surface. Another answer is
    /// defensible.
    Border,
}

/// Judges an answer for a case. `unit` is the relative rounding error of the numbers in which the answer
/// was computed, [`DOUBLE`] or [`SINGLE`].
#[must_use]
pub fn judge(case: &Case, found: Found, unit: f64) -> Verdict {
    let is_border = case.margin < ALLOWED * unit;
    let unless_border = |wrong| if is_border { Verdict::Border } else { wrong };
    match (&case.answer, found) {
        (_, Some(t)) if !t.is_finite() => Verdict::WrongValue,
        (Answer::Hit(hit), Some(t)) => {
            // One ulp is at most two rounding errors.
            let allowed = ALLOWED * case.condition.max(1.0) * 2.0 * unit * hit.t.abs();
            if (t - hit.t).abs() <= allowed {
                Verdict::Right
            } else {
                unless_border(Verdict::WrongValue)
            }
        }
        // Neither answer contradicts infinitely many hits.
        (Answer::Miss | Answer::NoShape, None) | (Answer::Coplanar, _) => Verdict::Right,
        (Answer::NoShape, Some(_)) => Verdict::WrongDecision,
        (Answer::Hit(_), None) | (Answer::Miss, Some(_)) => unless_border(Verdict::WrongDecision),
    }
}

/// How many answers got each verdict.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// All answers.
    pub asked: usize,
    /// [`Verdict::Right`].
    pub right: usize,
    /// [`Verdict::WrongDecision`].
    pub wrong_decisions: usize,
    /// [`Verdict::WrongValue`].
    pub wrong_values: usize,
    /// [`Verdict::Border`].
    pub borders: usize,
}

impl Tally {
    /// Counts one more answer.
    pub fn add(&mut self, verdict: Verdict) {
        self.asked += 1;
        match verdict {
            Verdict::Right => self.right += 1,
            Verdict::WrongDecision => self.wrong_decisions += 1,
            Verdict::WrongValue => self.wrong_values += 1,
            Verdict::Border => self.borders += 1,
        }
    }
}
