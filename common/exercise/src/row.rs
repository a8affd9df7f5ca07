//! `Row`: a question, its right answer, and how far another right answer may be from it.

use crate::{Answer, Question};

/// The change of an input by which right answers may differ, relative to each of its
/// numbers: more than the rounding errors of any right formula, less than an epsilon that
/// anybody would write.
const UNIT: f64 = 1e-9;

/// Some roundings of a number.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// How exact an answer must be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Precision {
    /// Right for an input that differs by 1e-9 of itself: every right formula is.
    Usual,
    /// Right for an input that differs by some roundings, because the exercise is about
    /// rounding.
    Rounding,
}

impl Precision {
    /// The change of an input, relative to each of its numbers.
    pub(crate) fn unit(self) -> f64 {
        match self {
            Self::Usual => UNIT,
            Self::Rounding => ROUNDING,
        }
    }
}

/// How far another right answer may be from an answer, through the change of its input.
///
/// An answer is right if it is the right answer at an input that differs from the question's by
/// rounding: so the tolerance follows from the condition of the input. Beside it, each number
/// may differ by the same part of its own magnitude.
#[derive(Clone, Debug, PartialEq)]
pub enum Tolerance {
    /// How far each number of the answer moves.
    Changes(Vec<f64>),
    /// The decision of the answer is another one at such an input: every answer is right.
    RoundingDecides,
}

impl Tolerance {
    /// The tolerance at a question, with this answer to it, of code that answers moved inputs.
    /// None of the inputs of a simple question moves.
    pub(crate) fn at(
        question: &Question,
        answer: &Answer,
        precision: Precision,
        code: &dyn Fn(&[f64]) -> Answer,
    ) -> Self {
        let perturbed = question.perturbed(precision.unit());
        let perturbed = perturbed.take_while(|_| !question.is_simple);
        let changes = answer.sum_of_movements(perturbed.map(|pair| pair.map(|input| code(&input))));
        changes.map_or(Self::RoundingDecides, |changes| {
            Self::Changes(changes.into_iter().map(rounded).collect())
        })
    }
}

/// At this input, several answers are right, because rounding decides among them.
pub(crate) struct NoSingleAnswer;

impl Tolerance {
    /// The first value of a right answer from which `yours` differs by more than this tolerance,
    /// and what it is.
    pub(crate) fn difference(
        &self,
        right: &Answer,
        yours: &Answer,
        precision: Precision,
    ) -> Result<Option<String>, NoSingleAnswer> {
        let roundings: Vec<_> = right.roundings(precision.unit()).collect();
        if right.difference(yours, &roundings).is_none() {
            return Ok(None);
        }
        let Self::Changes(changes) = self else {
            return Err(NoSingleAnswer);
        };
        let allowed: Vec<_> = roundings.iter().zip(changes).map(|(a, b)| a + b).collect();
        Ok(right.difference(yours, &allowed))
    }
}

/// A number with three digits: more would tell nothing of a tolerance.
fn rounded(change: f64) -> f64 {
    format!("{change:.2e}").parse().unwrap_or(change)
}

/// The right answer to a question.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The right answer.
    pub answer: Answer,
    /// How far another right answer may be from it.
    pub tolerance: Tolerance,
    /// In an exercise about rounding: how far the answer of a formula may be that is right but
    /// for rounding.
    pub usual_tolerance: Option<Tolerance>,
}

impl Row {
    /// The row of the right answer to a question, which code gives, in an exercise that is about
    /// rounding or not.
    pub fn new(
        question: &Question,
        is_about_rounding: bool,
        code: &dyn Fn(&[f64]) -> Answer,
    ) -> Self {
        let answer = code(&question.input);
        let tolerance = |precision| Tolerance::at(question, &answer, precision, code);
        let (tolerance, usual_tolerance) = if is_about_rounding {
            let usual = tolerance(Precision::Usual);
            (tolerance(Precision::Rounding), Some(usual))
        } else {
            (tolerance(Precision::Usual), None)
        };
        Self {
            answer,
            tolerance,
            usual_tolerance,
        }
    }

    /// How exact an answer must be.
    pub(crate) fn precision(&self) -> Precision {
        match self.usual_tolerance {
            Some(_) => Precision::Rounding,
            None => Precision::Usual,
        }
    }

    /// Compares another answer with the right one.
    pub(crate) fn compare(&self, yours: &Answer) -> Comparison {
        match self
            .tolerance
            .difference(&self.answer, yours, self.precision())
        {
            Ok(None) => Comparison::Right,
            Err(NoSingleAnswer) => Comparison::RoundingDecides,
            Ok(Some(difference)) => Comparison::Wrong {
                is_but_for_rounding: self.usual_tolerance.as_ref().is_some_and(|tolerance| {
                    let difference = tolerance.difference(&self.answer, yours, Precision::Usual);
                    !matches!(difference, Ok(Some(_)))
                }),
                difference,
            },
        }
    }
}

/// What a comparison finds.
pub(crate) enum Comparison {
    Right,
    /// The answer is another one than the row's, and no row could be right.
    RoundingDecides,
    Wrong {
        /// The first value that differs, and what it must be.
        difference: String,
        /// Whether the answer is right for an input that differs by more than rounding.
        is_but_for_rounding: bool,
    },
}
