//! `Tolerance`: how far another right answer may be from a right answer.

use crate::answers::{Answer, Question};

/// The change of an input by which right answers may differ, relative to each of its
/// numbers: more than the rounding errors of any right formula, less than an epsilon that
/// anybody would write.
const UNIT: f64 = 1e-9;

/// How far another right answer may be from an answer, through the change of its input.
///
/// An answer is right if it is the right answer at an input that differs from the question's by
/// rounding: so the tolerance follows from the condition of the input. Beside it, each number
/// may differ by the same part of its own magnitude.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Tolerance {
    /// How far each number of the answer moves.
    Changes(Vec<f64>),
    /// The decision of the answer is another one at such an input: every answer is right.
    #[default]
    RoundingDecides,
}

impl Tolerance {
    /// That of an answer of which no number moves.
    pub(crate) fn none(answer: &Answer) -> Self {
        Self::Changes(answer.roundings(0.0).map(|_| 0.0).collect())
    }

    /// The tolerance at a question, with this answer to it, of code that answers moved inputs.
    /// None of the inputs of a simple question moves.
    pub(crate) fn at(
        question: &Question,
        answer: &Answer,
        code: &dyn Fn(&[f64]) -> Answer,
    ) -> Self {
        let perturbed = question.perturbed(UNIT);
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
    ) -> Result<Option<String>, NoSingleAnswer> {
        let roundings: Vec<_> = right.roundings(UNIT).collect();
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
