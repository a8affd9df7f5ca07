//! `verdict`: the only comparison of answers.

use std::cmp::Reverse;

use crate::answers::tolerance::NoSingleAnswer;
use crate::answers::{Answer, KnownMistake, Record, RightAnswer};

/// A student's answer to a question.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StudentAnswer {
    /// The question in words.
    pub question: String,
    /// The answer; none if the program panics.
    pub answer: Option<Answer>,
}

/// The findings about a student's answers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Verdict {
    /// Messages about what is wrong; empty if the answers are right.
    pub wrong: Vec<String>,
    /// The sentence about a known mistake that explains the wrong answers.
    pub known: Option<String>,
    /// The number of answers of which some would be wrong.
    pub compared: usize,
    /// How many of them are wrong.
    pub differ: usize,
}

/// The comparison of the picture that a student's program paints with the right one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Painted {
    /// Whether it has the right colours.
    pub is_right: bool,
    /// The comparison in words.
    pub words: String,
}

impl Verdict {
    /// Adds a picture. One that is right acquits no code, and is told only beside wrong answers.
    pub fn add_picture(&mut self, painted: &Painted) {
        if !(painted.is_right && self.wrong.is_empty()) {
            self.wrong.push(painted.words.clone());
        }
    }
}

/// Compares a student's answers with the right ones.
#[must_use]
pub fn verdict(record: &Record, yours: &[StudentAnswer]) -> Verdict {
    let mut found = Verdict::default();
    let mut first = None;
    let mut first_panic = None;
    let mut answers = Vec::new();
    for (number, question) in record.questions.iter().enumerate() {
        let given = yours.get(number);
        let Ok(difference) = difference(&question.right, given) else {
            answers.push(None);
            continue;
        };
        found.compared += 1;
        let answer = given.and_then(|given| given.answer.clone());
        if let Some(difference) = &difference {
            found.differ += 1;
            let text = given.map_or("the next question", |given| &given.question);
            let panics = given.is_some() && answer.is_none();
            if panics && first_panic.is_none() {
                // The input of the first difference stands above it.
                first_panic = Some(first.is_some().then(|| format!("it panics at: {text}")));
            }
            first.get_or_insert_with(|| format!("{text}:\n    {difference}"));
        }
        answers.push(answer.map(|answer| (answer, difference.is_some())));
    }
    let asked = record.questions.len();
    if yours.len() > asked {
        found.compared += 1;
        found.differ += 1;
        first.get_or_insert_with(|| "the recorded answers are incomplete".to_owned());
    }
    found.wrong.extend(first);
    found.wrong.extend(first_panic.flatten());
    let (differ, compared) = (found.differ, found.compared);
    if differ > 0 {
        let count = format!("{differ} of {compared} comparisons differ");
        found.wrong.push(count);
        found.known = recognized(&record.mistakes, &answers, differ);
    } else if 2 * compared <= asked {
        found.wrong.push("nothing is compared".to_owned());
    }
    found
}

/// The first value in which an answer differs from the right one, and what it must be.
fn difference(
    right: &RightAnswer,
    given: Option<&StudentAnswer>,
) -> Result<Option<String>, NoSingleAnswer> {
    let Some(given) = given else {
        return Ok(Some(
            "there is no answer; the program ends before".to_owned(),
        ));
    };
    match &given.answer {
        Some(answer) => right.difference(answer),
        None => Ok(Some("it panics, with the message above".to_owned())),
    }
}

/// A sentence about the mistake that explains most of the wrong answers, and at least half.
fn recognized(
    mistakes: &[KnownMistake],
    answers: &[Option<(Answer, bool)>],
    differ: usize,
) -> Option<String> {
    let explaining = mistakes.iter().filter_map(|mistake| {
        let explained = mistake.explains(answers)?;
        (2 * explained >= differ).then_some((explained, &mistake.overlooks))
    });
    let (_, overlooks) = explaining.min_by_key(|(explained, _)| Reverse(*explained))?;
    Some(format!(
        "this is a known mistake; it overlooks that {overlooks}"
    ))
}
