//! `Mistake`: a mistake of learners, with the answers of code that makes it.

use std::collections::{BTreeMap, BTreeSet};

use crate::answers::Answer;
use crate::answers::row::{NoSingleAnswer, Row, Tolerance};

/// The most answers of a mistake that are recorded; of the others it is known that they are
/// wrong.
const MAX_ANSWERS: usize = 4;

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
    /// Rows in which rounding decides what code with this mistake answers, or of which nothing is known.
    pub undecided_rows: BTreeSet<usize>,
}

impl Mistake {
    /// The mistake of a program with these rows instead of the right ones.
    #[must_use]
    pub fn new(overlooks: &str, right: &[Row], its: &[Row]) -> Self {
        let mut mistake = Self {
            overlooks: overlooks.to_owned(),
            ..Self::default()
        };
        for (number, (right, its)) in right.iter().zip(its).enumerate() {
            if !matches!(right.difference(&its.answer), Ok(Some(_))) {
                continue;
            }
            if mistake.answers.len() < MAX_ANSWERS {
                let answer = (its.answer.clone(), its.tolerance.clone());
                mistake.answers.insert(number, answer);
            } else if its.tolerance == Tolerance::RoundingDecides {
                mistake.undecided_rows.insert(number);
            } else {
                mistake.further_wrong_rows.insert(number);
            }
        }
        mistake
    }

    /// The number of its wrong answers.
    #[must_use]
    pub fn wrong_rows(&self) -> usize {
        self.answers.len() + self.further_wrong_rows.len()
    }

    /// The answers of a program that makes this mistake, with the right ones where nothing is known.
    #[must_use]
    pub fn answers(&self, rows: &[Row]) -> Vec<Answer> {
        let mut answers = Vec::new();
        for (number, row) in rows.iter().enumerate() {
            answers.push(match self.answers.get(&number) {
                Some((answer, _)) => answer.clone(),
                None if self.further_wrong_rows.contains(&number) => {
                    Answer::words("another answer")
                }
                None => row.answer.clone(),
            });
        }
        answers
    }

    /// The number of wrong answers that this mistake explains; `None` if an answer contradicts it, or
    /// if all wrong ones are to questions of which it is not known how it answers them.
    /// Each answer stands with whether it is wrong, or is `None` where rounding decides the right
    /// one.
    pub(crate) fn explains(&self, answers: &[Option<(Answer, bool)>]) -> Option<usize> {
        let mut explained = 0;
        let mut is_told = false;
        for (number, answer) in answers.iter().enumerate() {
            let Some((yours, is_wrong)) = answer else {
                continue;
            };
            let is_undecided = self.undecided_rows.contains(&number);
            is_told |= *is_wrong && !is_undecided;
            let has_mistake = match self.answers.get(&number) {
                Some((answer, tolerance)) => match tolerance.difference(answer, yours) {
                    Ok(difference) => difference.is_none(),
                    Err(NoSingleAnswer) => continue,
                },
                None if is_undecided => true,
                None => self.further_wrong_rows.contains(&number) == *is_wrong,
            };
            if !has_mistake {
                return None;
            }
            explained += usize::from(*is_wrong);
        }
        is_told.then_some(explained)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where it is not known how a mistake answers, a wrong answer does not tell that code makes it.
    #[test]
    fn undecided_answers_tell_no_mistake() {
        let decides = (Answer::words("none"), Tolerance::RoundingDecides);
        let mistake = Mistake {
            answers: [(0, decides)].into(),
            undecided_rows: [1].into(),
            ..Mistake::default()
        };
        let explains = |first| {
            let answers = [first, true].map(|is_wrong| Some((Answer::words("1"), is_wrong)));
            mistake.explains(&answers)
        };
        assert_eq!(explains(true), Some(1));
        assert_eq!(explains(false), None);
    }
}
