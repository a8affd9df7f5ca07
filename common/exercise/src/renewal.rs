//! A record with the right answers of other questions: known mistakes keep the rows that still fit.

use std::collections::{BTreeSet, HashMap};

use crate::{Mistake, Record, Row};

impl Record {
    /// This record with other rows. The known mistakes follow the questions of theirs; how they answer
    /// the other questions is not known. Messages say which mistakes lose rows.
    #[must_use]
    pub fn with_rows(self, rows: Vec<Row>) -> (Self, Vec<String>) {
        let places = places(&self.rows, &rows);
        let known: BTreeSet<_> = places.iter().flatten().copied().collect();
        let new: BTreeSet<_> = (0..rows.len()).filter(|row| !known.contains(row)).collect();
        let (mut mistakes, mut messages) = (Vec::new(), Vec::new());
        for old in self.mistakes {
            let mut mistake = old.at(&places);
            let overlooks = &mistake.overlooks;
            let lost = old.wrong_rows() - mistake.wrong_rows();
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
                    "{lost} of {} answers that overlook that {overlooks} do not fit the questions, and are \
                     dropped",
                    old.wrong_rows()
                ));
            }
            mistake.undecided_rows.extend(&new);
            mistakes.push(mistake);
        }
        let renewed = Self {
            rows,
            mistakes,
            ..self
        };
        (renewed, messages)
    }
}

/// The new row of each old one: of the same question, as often as it is asked, with the same right
/// answer.
fn places(old: &[Row], new: &[Row]) -> Vec<Option<usize>> {
    let mut asked: HashMap<&str, Vec<usize>> = HashMap::new();
    for (place, row) in new.iter().enumerate().rev() {
        asked.entry(&row.key).or_default().push(place);
    }
    let mut places = Vec::new();
    for row in old {
        let place = asked.get_mut(&*row.key).and_then(Vec::pop);
        let fits = |place: &usize| !matches!(new[*place].difference(&row.answer), Ok(Some(_)));
        places.push(place.filter(fits));
    }
    places
}

impl Mistake {
    /// This mistake where its rows are among others.
    fn at(&self, places: &[Option<usize>]) -> Self {
        let place = |row: &usize| places.get(*row).copied().flatten();
        let moved = |rows: &BTreeSet<usize>| rows.iter().filter_map(place).collect();
        let mut at = Self {
            overlooks: self.overlooks.clone(),
            further_wrong_rows: moved(&self.further_wrong_rows),
            undecided_rows: moved(&self.undecided_rows),
            ..Self::default()
        };
        for (row, answer) in &self.answers {
            if let Some(place) = place(row) {
                at.answers.insert(place, answer.clone());
            }
        }
        at
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Answer, Question, StudentAnswer, verdict};

    /// The answer of right code is the number, that of the mistake its negative.
    fn record(numbers: &[f64]) -> Record {
        let (mut rows, mut its) = (Vec::new(), Vec::new());
        for number in numbers {
            let question = Question::new("the number {}", number, true);
            rows.push(Row::new(&question, &|input| input[0].into()));
            its.push(Row::new(&question, &|input| (-input[0]).into()));
        }
        let mistakes = vec![Mistake::new("a sign is kept", &rows, &its)];
        Record {
            rows,
            mistakes,
            ..Record::default()
        }
    }

    fn rows(numbers: &[f64]) -> Vec<Row> {
        record(numbers).rows
    }

    #[test]
    fn an_inserted_question_moves_no_answer_of_a_mistake_to_another_question() {
        let (record, messages) =
            record(&[1.0, 2.0, 2.0, 3.0]).with_rows(rows(&[1.0, 2.0, 9.0, 2.0, 3.0]));
        assert_eq!(messages, [""; 0]);
        let given = [-1.0, -2.0, 9.0, -2.0, -3.0].map(|number| StudentAnswer {
            question: String::new(),
            answer: Some(number.into()),
        });
        let known = verdict(&record, &given).known.unwrap();
        assert!(known.ends_with("that a sign is kept"), "{known}");
        assert_eq!(record.mistakes[0].undecided_rows, [2].into());
    }

    #[test]
    fn rows_of_questions_that_are_gone_or_have_another_right_answer_are_dropped_with_a_message() {
        let mut changed = rows(&[1.0, 3.0]);
        changed[0].answer = Answer::from(7.0);
        let (record, messages) = record(&[1.0, 2.0, 3.0]).with_rows(changed);
        assert_eq!(
            messages,
            [
                "2 of 3 answers that overlook that a sign is kept do not fit the questions, and are dropped"
            ]
        );
        assert_eq!(record.mistakes[0].answers.keys().collect::<Vec<_>>(), [&1]);
        let (record, messages) = record.with_rows(rows(&[4.0]));
        assert!(record.mistakes.is_empty());
        assert!(
            messages[0].contains("cargo course mistake FILE \"a sign is kept\""),
            "{messages:?}"
        );
    }
}
