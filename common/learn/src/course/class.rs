//! `mistakes`: which mistakes a class has made.

use std::cmp::Reverse;

use ::exercise::{Record, answer_alike};

use super::outcome::{Cause, Graded};
use crate::exercise::Exercise;
use crate::files;

/// A mistake in an exercise, and who has made it.
pub struct ClassMistake {
    pub exercise: &'static Exercise,
    pub cause: Cause,
    /// The names of the submissions.
    pub names: Vec<String>,
}

impl ClassMistake {
    /// Whether it is a known mistake, an unknown one, or a program without answers.
    pub fn kind(&self) -> &'static str {
        match &self.cause {
            Cause::Known(_) => "known",
            Cause::Answers { .. } => "unknown",
            Cause::NoAnswers(_) => "no answers",
        }
    }

    /// The mistake in words; of an unknown one, the first wrong answer.
    pub fn words(&self) -> &str {
        match &self.cause {
            Cause::Known(words) | Cause::NoAnswers(words) => words,
            Cause::Answers { first, .. } => first,
        }
    }
}

/// The mistakes of a class, by exercise, and of each first those that most have made. Wrong answers
/// that are alike are one mistake.
pub fn mistakes(graded: &[Graded]) -> Result<Vec<ClassMistake>, String> {
    let mut all = Vec::new();
    let count = graded.first().map_or(0, |first| first.results.len());
    for number in 0..count {
        let mut of_exercise: Vec<ClassMistake> = Vec::new();
        for submission in graded {
            let judged = &submission.results[number];
            let Some(cause) = &judged.outcome.cause else {
                continue;
            };
            let mut same = None;
            for mistake in &mut of_exercise {
                if is_same(judged.exercise, &mistake.cause, cause)? {
                    same = Some(mistake);
                    break;
                }
            }
            match same {
                Some(mistake) => mistake.names.push(submission.name.clone()),
                None => of_exercise.push(ClassMistake {
                    exercise: judged.exercise,
                    cause: cause.clone(),
                    names: vec![submission.name.clone()],
                }),
            }
        }
        of_exercise.sort_by_key(|mistake| Reverse(mistake.names.len()));
        all.append(&mut of_exercise);
    }
    Ok(all)
}

/// Whether two programs have the same mistake.
fn is_same(e: &Exercise, one: &Cause, other: &Cause) -> Result<bool, String> {
    let (Cause::Answers { given: one, .. }, Cause::Answers { given: other, .. }) = (one, other)
    else {
        return Ok(one == other);
    };
    let file = format!("{}/exercises/answers/{}.txt", e.stage, e.name);
    let record = Record::read(&files::read(&file)?)?;
    Ok(answer_alike(&record, one, other))
}

#[cfg(test)]
mod tests {
    use ::exercise::{Answer, Question, StudentAnswer};

    use super::super::outcome::{Judged, Outcome};
    use super::*;

    #[test]
    fn equal_mistakes_are_one_and_the_most_frequent_is_first() {
        let exercise = crate::exercise::find("signed_distance").unwrap();
        let answers = |first: f64| Cause::Answers {
            given: vec![StudentAnswer {
                question: Question::default(),
                answer: Some(Answer::from(first)),
            }],
            first: "must be 1".to_owned(),
        };
        let known = || Cause::Known("overlooks that n may have any length".to_owned());
        let mut graded = Vec::new();
        for (name, cause) in [
            ("ada", Some(known())),
            ("bob", Some(answers(1.5))),
            ("cy", Some(answers(1.5 + 4e-16))),
            ("dan", Some(answers(2.5))),
            ("eve", None),
            ("fay", Some(answers(1.5))),
            ("gil", Some(known())),
        ] {
            let outcome = Outcome {
                cause,
                ..Outcome::not_handed_in()
            };
            graded.push(Graded {
                name: name.to_owned(),
                results: vec![Judged {
                    exercise,
                    file: String::new(),
                    outcome,
                    most: 1.0,
                    points: 0.0,
                }],
            });
        }
        let mut rows = Vec::new();
        for mistake in mistakes(&graded).unwrap() {
            rows.push((mistake.kind(), mistake.names.join(" ")));
        }
        let row = |kind, names: &str| (kind, names.to_owned());
        let expected = [
            row("unknown", "bob cy fay"),
            row("known", "ada gil"),
            row("unknown", "dan"),
        ];
        assert_eq!(rows, expected);
    }
}
