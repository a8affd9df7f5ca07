//! A record with the right answers of changed questions: known mistakes keep the answers that still fit.

use std::collections::BTreeSet;
use std::mem;

use crate::answers::{Record, RightAnswer};

impl Record {
    /// This record with these right answers to its questions. How the known mistakes answer a question
    /// whose right answer was another one, or none, is not known. Messages say which mistakes lose answers.
    #[must_use]
    pub fn renewed(self, right_answers: Vec<RightAnswer>) -> (Self, Vec<String>) {
        let mut new = BTreeSet::new();
        for (number, (old, right)) in self.questions.iter().zip(&right_answers).enumerate() {
            if matches!(right.difference(&old.right.answer), Ok(Some(_))) {
                new.insert(number);
            }
        }
        let mut renewed = self.with_answers(right_answers);
        let mut messages = Vec::new();
        for mut mistake in mem::take(&mut renewed.mistakes) {
            let before = mistake.wrong_count();
            mistake
                .answers
                .retain(|question, _| !new.contains(question));
            mistake
                .further_wrong
                .retain(|question| !new.contains(question));
            let (overlooks, lost) = (&mistake.overlooks, before - mistake.wrong_count());
            if mistake.answers.is_empty() {
                messages.push(format!(
                    "the mistake that overlooks that {overlooks} is dropped, because no answer of it fits \
                     the questions; a program that makes it records it again: \
                     cargo course mistake FILE \"{overlooks}\""
                ));
                continue;
            }
            if lost > 0 {
                messages.push(format!(
                    "{lost} of {before} answers that overlook that {overlooks} do not fit the questions, and \
                     are dropped"
                ));
            }
            mistake.undecided.extend(&new);
            renewed.mistakes.push(mistake);
        }
        (renewed, messages)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answers::{StudentAnswer, verdict};

    /// The right answer is the number, that of the mistake its negative. One question is new.
    const FILE: &str = "\
mistake m1 a sign is kept
words the number {}
simple 1 = 1
  m1 = -1
simple 9
simple 2 = 2
  m1 = -2
";

    /// The record with these right answers.
    fn renewed(numbers: [f64; 3]) -> (Record, Vec<String>) {
        let right = numbers.map(|number| RightAnswer::default().with_answer(number.into()));
        Record::read(FILE).unwrap().renewed(right.into())
    }

    #[test]
    fn of_a_new_question_it_is_not_known_how_mistakes_answer() {
        let (record, messages) = renewed([1.0, 9.0, 2.0]);
        assert_eq!(messages, [""; 0]);
        let given = [-1.0, 9.0, -2.0].map(|number| StudentAnswer {
            question: String::new(),
            answer: Some(number.into()),
        });
        let known = verdict(&record, &given).known.unwrap();
        assert!(known.ends_with("that a sign is kept"), "{known}");
        assert_eq!(record.mistakes[0].undecided, [1].into());
    }

    #[test]
    fn answers_to_questions_with_another_right_answer_are_dropped_with_a_message() {
        let (record, messages) = renewed([7.0, 9.0, 2.0]);
        assert_eq!(
            messages,
            [
                "1 of 2 answers that overlook that a sign is kept do not fit the questions, and are dropped"
            ]
        );
        assert_eq!(record.mistakes[0].answers.keys().collect::<Vec<_>>(), [&2]);
        let (record, messages) = renewed([7.0, 9.0, 8.0]);
        assert!(record.mistakes.is_empty());
        assert!(
            messages[0].contains("cargo course mistake FILE \"a sign is kept\""),
            "{messages:?}"
        );
    }
}
