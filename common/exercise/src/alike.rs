//! `answer_alike`: whether two programs make the same mistake.

use crate::row::NoSingleAnswer;
use crate::{Record, StudentAnswer};

/// Whether two programs give the same answers to all questions, up to rounding: so they make the
/// same mistake, also where nobody knows which.
///
/// Two answers may differ by as much as right answers may. A question without an answer, after a
/// panic or because the program ends before, is alike to another one without an answer.
#[must_use]
pub fn answer_alike(record: &Record, one: &[StudentAnswer], other: &[StudentAnswer]) -> bool {
    record.rows.iter().enumerate().all(|(number, row)| {
        let [one, other] = [one, other].map(|all| all.get(number)?.answer.as_ref());
        match (one, other) {
            (Some(one), Some(other)) => {
                match row.tolerance.difference(one, other, row.precision()) {
                    Ok(difference) => difference.is_none(),
                    Err(NoSingleAnswer) => true,
                }
            }
            (None, None) => true,
            _ => false,
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Answer, Question, Row, Tolerance};

    fn given(answers: &[f64]) -> Vec<StudentAnswer> {
        let answers = answers.iter().map(|answer| StudentAnswer {
            question: Question::default(),
            answer: Some(Answer::from(*answer)),
        });
        answers.collect()
    }

    #[test]
    fn programs_that_round_differently_answer_alike() {
        let row = |answer: f64, tolerance| Row {
            question: Question::default(),
            answer: Answer::from(answer),
            tolerance,
            usual_tolerance: None,
        };
        let record = Record {
            rows: vec![
                row(1.0, Tolerance::Changes(vec![0.0])),
                row(2.0, Tolerance::Changes(vec![0.0])),
                row(3.0, Tolerance::RoundingDecides),
            ],
            ..Record::default()
        };
        let wrong = given(&[5.0, 2.0, 3.0]);
        let alike = |other: &[StudentAnswer]| answer_alike(&record, &wrong, other);
        assert!(alike(&wrong));
        assert!(alike(&given(&[5.0 + 4e-15, 2.0, 7.0])));
        assert!(!alike(&given(&[5.1, 2.0, 3.0])));
        assert!(!alike(&given(&[5.0])), "the program ends before");
        let mut panics = given(&[5.0, 2.0, 3.0]);
        panics[1].answer = None;
        assert!(!alike(&panics));
    }
}
