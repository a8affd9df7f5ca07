//! `Mistake`: a mistake of learners, with the answers of code that makes it.

use std::collections::{BTreeMap, BTreeSet};

use crate::row::{NoSingleAnswer, Row, Tolerance};
use crate::{Answer, Question};

/// The most answers of a mistake that are recorded; of the others it is known that they are
/// wrong.
const MOST: usize = 4;

/// A mistake of learners, and how code that makes it answers the questions of an exercise. Its
/// answers are the right ones in the rows that nothing is said about.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mistake {
    /// The fact that it overlooks, after which learners read "that".
    pub overlooks: String,
    /// Wrong answers, by the number of the row, from 0.
    pub answers: BTreeMap<usize, (Answer, Tolerance)>,
    /// Further rows with wrong answers, which are not recorded.
    pub further_wrong_rows: BTreeSet<usize>,
    /// Rows in which rounding decides what code with this mistake answers.
    pub undecided_rows: BTreeSet<usize>,
}

impl Mistake {
    /// The mistake of this code, which answers the questions of the rows by their numbers, and
    /// input.
    pub fn new(
        overlooks: &str,
        rows: &[Row],
        questions: &[Question],
        code: &dyn Fn(usize, &[f64]) -> Answer,
    ) -> Self {
        let mut mistake = Self {
            overlooks: overlooks.to_owned(),
            ..Self::default()
        };
        for (number, (row, question)) in rows.iter().zip(questions).enumerate() {
            let code = |input: &[f64]| code(number, input);
            let answer = code(&question.input);
            if !matches!(row.difference(&answer), Ok(Some(_))) {
                continue;
            }
            let tolerance = Tolerance::at(question, &answer, &code);
            if mistake.answers.len() < MOST {
                mistake.answers.insert(number, (answer, tolerance));
            } else if tolerance == Tolerance::RoundingDecides {
                mistake.undecided_rows.insert(number);
            } else {
                mistake.further_wrong_rows.insert(number);
            }
        }
        mistake
    }

    /// The number of wrong answers that this mistake explains; `None` if an answer contradicts it.
    /// Each answer stands with whether it is wrong, or is `None` where rounding decides the right
    /// one.
    pub(crate) fn explains(&self, answers: &[Option<(Answer, bool)>]) -> Option<usize> {
        let mut explained = 0;
        for (number, answer) in answers.iter().enumerate() {
            let Some((yours, is_wrong)) = answer else {
                continue;
            };
            let has_mistake = match self.answers.get(&number) {
                Some((answer, tolerance)) => match tolerance.difference(answer, yours) {
                    Ok(difference) => difference.is_none(),
                    Err(NoSingleAnswer) => continue,
                },
                None if self.undecided_rows.contains(&number) => true,
                None => self.further_wrong_rows.contains(&number) == *is_wrong,
            };
            if !has_mistake {
                return None;
            }
            explained += usize::from(*is_wrong);
        }
        Some(explained)
    }
}
