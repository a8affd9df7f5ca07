//! `verdict`: the only comparison of answers.

use std::cmp::Reverse;

use crate::row::Comparison;
use crate::{Answer, Mistake, Question, Record, Row};

/// A student's answer to a question.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StudentAnswer {
    /// The question.
    pub question: Question,
    /// The answer; none if the program panics.
    pub answer: Option<Answer>,
}

/// What a comparison of the student's picture of a scene says.
#[derive(Clone, Debug, PartialEq)]
pub struct PictureVerdict {
    /// Whether the picture is right.
    pub is_right: bool,
    /// The words about it.
    pub words: String,
    /// The first step of a pixel in which the student's code and the lesson part, for answers or
    /// a picture that are wrong.
    pub divergence: Option<String>,
}

/// The findings about a student's answers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Verdict {
    /// Messages about what is wrong; empty if the answers are right.
    pub wrong: Vec<String>,
    /// A remark, such as that the picture is right.
    pub note: Option<String>,
    /// The sentence about a known mistake that explains the wrong answers.
    pub known: Option<String>,
    /// The number of comparisons: those of the answers, and that of the picture.
    pub compared: usize,
    /// In how many of them the answer or the picture is wrong.
    pub differ: usize,
}

/// Compares a student's answers with the right ones, and, if there is one, adds what the
/// comparison of the picture says.
#[must_use]
pub fn verdict(
    record: &Record,
    yours: &[StudentAnswer],
    picture: Option<PictureVerdict>,
) -> Verdict {
    let rows = &record.rows;
    let mut found = Verdict::default();
    let (mut compared, mut skipped, mut differ) = (0, 0, 0);
    let mut first = None;
    let mut answers = Vec::new();
    for (number, row) in rows.iter().enumerate() {
        let given = yours.get(number);
        let text = given.map_or(&row.question.text, |given| &given.question.text);
        let difference = match given.map(|given| given.answer.as_ref()) {
            None => Some("there is no answer; the program ends before".to_owned()),
            Some(None) => Some("it panics, with the message above".to_owned()),
            Some(Some(answer)) => match row.compare(answer) {
                Comparison::Right => None,
                Comparison::RoundingDecides => {
                    skipped += 1;
                    answers.push(None);
                    continue;
                }
                Comparison::Wrong {
                    difference,
                    is_but_for_rounding,
                } => Some(match &record.rounding_flaw {
                    Some(flaw) if is_but_for_rounding => {
                        format!("{difference}\n    right but for rounding: the formula {flaw}")
                    }
                    _ => difference,
                }),
            },
        };
        let is_wrong = difference.is_some();
        let answer = given.and_then(|given| given.answer.clone());
        answers.push(answer.map(|answer| (answer, is_wrong)));
        compared += 1;
        differ += usize::from(is_wrong);
        first = first.or_else(|| Some(format!("{text}:\n    {}", difference?)));
    }
    if yours.len() > rows.len() {
        compared += 1;
        differ += 1;
        first = first.or(Some("the recorded answers are incomplete".to_owned()));
    }
    if let Some(PictureVerdict {
        is_right,
        mut words,
        divergence,
    }) = picture
    {
        let is_wanted = differ > 0 || !is_right;
        if let Some(divergence) = divergence.filter(|_| is_wanted) {
            words.extend(["\n", &divergence]);
        }
        if differ > 0 || is_right {
            compared += usize::from(is_right);
            found.note = Some(words);
        } else {
            compared += 1;
            differ = 1;
            first = Some(words);
        }
    }
    found.wrong.extend(first);
    found.compared = compared;
    found.differ = differ;
    if differ > 0 {
        found
            .wrong
            .push(format!("{differ} of {compared} comparisons differ"));
        found.known = recognized(&record.mistakes, rows, &answers, differ);
    } else if compared <= skipped {
        found.wrong.push("nothing is compared".to_owned());
    }
    found
}

/// A sentence about the mistake that explains most of the wrong answers, and at least half.
fn recognized(
    mistakes: &[Mistake],
    rows: &[Row],
    answers: &[Option<(Answer, bool)>],
    differ: usize,
) -> Option<String> {
    let explaining = mistakes.iter().filter_map(|mistake| {
        let explained = mistake.explains(rows, answers)?;
        (2 * explained >= differ).then_some((explained, &mistake.overlooks))
    });
    let (_, overlooks) = explaining.min_by_key(|(explained, _)| Reverse(*explained))?;
    Some(format!(
        "this is a known mistake; it overlooks that {overlooks}"
    ))
}
