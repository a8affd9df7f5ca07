//! `RightAnswer`: what a question is to be answered, and how far another right answer may be from it.

use crate::answers::tolerance::{NoSingleAnswer, Tolerance};
use crate::answers::{Answer, Question};

/// The right answer to a question; by default none yet.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RightAnswer {
    /// The right answer.
    pub answer: Answer,
    /// How far another right answer may be from it.
    pub tolerance: Tolerance,
}

impl RightAnswer {
    /// The right answer to a question, which code gives.
    pub fn new(question: &Question, code: &dyn Fn(&[f64]) -> Answer) -> Self {
        let answer = code(&question.input);
        let tolerance = Tolerance::at(question, &answer, code);
        Self { answer, tolerance }
    }

    /// Whether there is one: a question that was just added has none.
    #[must_use]
    pub fn is_recorded(&self) -> bool {
        self.answer != Answer::default()
    }

    /// Another answer to this question as if it were right; it may differ as far as the right one may.
    #[must_use]
    pub fn with_answer(&self, answer: Answer) -> Self {
        let mut other = Self {
            answer,
            ..self.clone()
        };
        if !other.answer.has_same_form(&self.answer) {
            other.tolerance = Tolerance::none(&other.answer);
        }
        other
    }

    /// The first value from which another one differs, and what it is.
    pub(crate) fn difference(&self, yours: &Answer) -> Result<Option<String>, NoSingleAnswer> {
        self.tolerance.difference(&self.answer, yours)
    }
}
