//! `KnownMistake`: a mistake of learners, with the answers of code that makes it.

use std::collections::{BTreeMap, BTreeSet};

use crate::answers::tolerance::{NoSingleAnswer, Tolerance};
use crate::answers::{Answer, QuestionLine, RightAnswer};

/// The most answers of a mistake that are recorded; of the others it is known that they are
/// wrong.
const MAX_ANSWERS: usize = 4;

/// A mistake of learners, and how code that makes it answers the questions of an exercise. It gives
/// the right answers to the questions that nothing is said about.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct KnownMistake {
    /// The fact that it overlooks, after which learners read "that".
    pub overlooks: String,
    /// Wrong answers, by the number of the question, from 0.
    pub answers: BTreeMap<usize, (Answer, Tolerance)>,
    /// Further questions with wrong answers, which are not recorded.
    pub further_wrong: BTreeSet<usize>,
    /// Questions of which rounding decides what code with this mistake answers, or nothing is known.
    pub undecided: BTreeSet<usize>,
}

impl KnownMistake {
    /// The mistake of a program with these answers to the questions instead of the right ones.
    #[must_use]
    pub fn new(overlooks: &str, questions: &[QuestionLine], its: &[RightAnswer]) -> Self {
        let mut mistake = Self {
            overlooks: overlooks.to_owned(),
            ..Self::default()
        };
        for (number, (question, its)) in questions.iter().zip(its).enumerate() {
            if !matches!(question.right.difference(&its.answer), Ok(Some(_))) {
                continue;
            }
            if mistake.answers.len() < MAX_ANSWERS {
                let answer = (its.answer.clone(), its.tolerance.clone());
                mistake.answers.insert(number, answer);
            } else if its.tolerance == Tolerance::RoundingDecides {
                mistake.undecided.insert(number);
            } else {
                mistake.further_wrong.insert(number);
            }
        }
        mistake
    }

    /// The number of its wrong answers.
    #[must_use]
    pub fn wrong_count(&self) -> usize {
        self.answers.len() + self.further_wrong.len()
    }

    /// The answers of a program that makes this mistake, with the right ones where nothing is known.
    #[must_use]
    pub fn answers(&self, questions: &[QuestionLine]) -> Vec<Answer> {
        let mut answers = Vec::new();
        for (number, question) in questions.iter().enumerate() {
            answers.push(match self.answers.get(&number) {
                Some((answer, _)) => answer.clone(),
                None if self.further_wrong.contains(&number) => Answer::words("another answer"),
                None => question.right.answer.clone(),
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
            let is_undecided = self.undecided.contains(&number);
            is_told |= *is_wrong && !is_undecided;
            let has_mistake = match self.answers.get(&number) {
                Some((answer, tolerance)) => match tolerance.difference(answer, yours) {
                    Ok(difference) => difference.is_none(),
                    Err(NoSingleAnswer) => continue,
                },
                None if is_undecided => true,
                None => self.further_wrong.contains(&number) == *is_wrong,
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
        let mistake = KnownMistake {
            answers: [(0, decides)].into(),
            undecided: [1].into(),
            ..KnownMistake::default()
        };
        let explains = |first| {
            let answers = [first, true].map(|is_wrong| Some((Answer::words("1"), is_wrong)));
            mistake.explains(&answers)
        };
        assert_eq!(explains(true), Some(1));
        assert_eq!(explains(false), None);
    }
}
