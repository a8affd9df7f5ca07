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
    /// What messages call it, such as `the picture of scene sphere`.
    pub name: String,
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

/// The comparisons so far.
#[derive(Default)]
struct Counts {
    /// All comparisons that decide something.
    compared: usize,
    /// Rows in which rounding decides, and every answer is right.
    skipped: usize,
    /// Comparisons that find a wrong answer or a wrong picture.
    wrong: usize,
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
    let mut counts = Counts::default();
    let mut first = None;
    let mut first_panic = None;
    let mut answers = Vec::new();
    for (number, row) in rows.iter().enumerate() {
        let given = yours.get(number);
        let answer = given.and_then(|given| given.answer.as_ref());
        let finding = find(record, row, given);
        if let Finding::RoundingDecides = finding {
            counts.skipped += 1;
            answers.push(None);
            continue;
        }
        counts.compared += 1;
        let mut is_wrong = false;
        if let Finding::Wrong(difference) = finding {
            is_wrong = true;
            counts.wrong += 1;
            let text = given.map_or("the next question", |given| &given.question.text);
            let panics = given.is_some() && answer.is_none();
            if panics && first_panic.is_none() {
                // The input of the first difference stands above it.
                first_panic = Some(first.is_some().then(|| format!("it panics at: {text}")));
            }
            first.get_or_insert_with(|| format!("{text}:\n    {difference}"));
        }
        answers.push(answer.map(|answer| (answer.clone(), is_wrong)));
    }
    if yours.len() > rows.len() {
        counts.compared += 1;
        counts.wrong += 1;
        first.get_or_insert_with(|| "the recorded answers are incomplete".to_owned());
    }
    if let Some(picture) = picture {
        counts.compared += usize::from(picture.is_right || counts.wrong == 0);
        if counts.wrong > 0 {
            found.note = Some(picture.beside_wrong_answers());
        } else if picture.is_right {
            found.note = Some(picture.comparison());
        } else {
            counts.wrong = 1;
            first = Some(picture.with_divergence(picture.comparison()));
        }
    }
    found.wrong.extend(first);
    found.wrong.extend(first_panic.flatten());
    let Counts {
        compared,
        skipped,
        wrong,
    } = counts;
    found.compared = compared;
    found.differ = wrong;
    if wrong > 0 {
        let count = format!("{wrong} of {compared} comparisons differ");
        found.wrong.push(count);
        found.known = recognized(&record.mistakes, rows, &answers, wrong);
    } else if compared <= skipped {
        found.wrong.push("nothing is compared".to_owned());
    }
    found
}

/// What is found about an answer.
enum Finding {
    Right,
    /// No answer could be wrong.
    RoundingDecides,
    /// The first value that differs, and what it must be.
    Wrong(String),
}

/// Compares an answer with the right one of a row.
fn find(record: &Record, row: &Row, given: Option<&StudentAnswer>) -> Finding {
    let Some(given) = given else {
        return Finding::Wrong("there is no answer; the program ends before".to_owned());
    };
    let Some(answer) = &given.answer else {
        return Finding::Wrong("it panics, with the message above".to_owned());
    };
    match row.compare(answer) {
        Comparison::Right => Finding::Right,
        Comparison::RoundingDecides => Finding::RoundingDecides,
        Comparison::Wrong {
            difference,
            is_but_for_rounding,
        } => Finding::Wrong(match &record.rounding_flaw {
            Some(flaw) if is_but_for_rounding => {
                format!("{difference}\n    right but for rounding: the formula {flaw}")
            }
            _ => difference,
        }),
    }
}

impl PictureVerdict {
    fn comparison(&self) -> String {
        format!("{}: {}", self.name, self.words)
    }

    /// The words beside wrong answers or a failed example. A picture that is right acquits no code: the scene does not
    /// show what is wrong.
    #[must_use]
    pub fn beside_wrong_answers(&self) -> String {
        self.with_divergence(match (self.is_right, &self.divergence) {
            (true, None) => format!("{} does not show it", self.name),
            (true, Some(_)) => format!("{} has the right colours", self.name),
            (false, _) => self.comparison(),
        })
    }

    /// These words, and the first step in which both traces part.
    fn with_divergence(&self, words: String) -> String {
        match &self.divergence {
            Some(divergence) => format!("{words}\n{divergence}"),
            None => words,
        }
    }
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
