//! `Record`: the file of an exercise: what is asked, what is right, and what is known to go wrong.
//!
//! A line begins with the word that says what it is. `mistake m1` has the fact that a known mistake
//! overlooks. `words` begins the questions of one form, with `{}` instead of each argument. `simple` or
//! `other` asks one, with `|` between its arguments. After `=` stands its right answer, and after `~` how
//! far the numbers of the answer may move, beside their own rounding: nothing where they must not, and
//! `rounding decides` where every answer is right. The lines below it tell of code with known mistakes:
//! its answer, such as `m1 = 0`; `wrong`, for which mistakes another one is wrong; and `either`, for which
//! it is not known.

mod reader;

use std::fmt::{self, Write};

use self::reader::Reader;
use crate::answers::{Answer, KnownMistake, QuestionLine, RightAnswer, Tolerance, text};

/// Questions, right answers and known mistakes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Record {
    /// The questions, each with its right answer.
    pub questions: Vec<QuestionLine>,
    /// The known mistakes.
    pub mistakes: Vec<KnownMistake>,
    /// The lines below the last question that ask nothing.
    pub below: String,
}

impl fmt::Display for Record {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mistakes = || (1..).zip(&self.mistakes);
        for (label, mistake) in mistakes() {
            writeln!(f, "mistake m{label} {}", mistake.overlooks)?;
        }
        for (number, question) in self.questions.iter().enumerate() {
            let QuestionLine {
                above,
                arguments,
                right,
                ..
            } = question;
            let answer = if right.is_recorded() {
                answer_line(&right.answer, &right.tolerance)
            } else {
                String::new()
            };
            let word = if question.is_simple {
                "simple"
            } else {
                "other"
            };
            let line = format!("{word} {arguments} {answer}");
            writeln!(f, "{above}{}", line.trim_end())?;
            for (label, mistake) in mistakes() {
                if let Some((answer, tolerance)) = mistake.answers.get(&number) {
                    writeln!(f, "  m{label} {}", answer_line(answer, tolerance))?;
                }
            }
            let wrong = mistakes().filter(|(_, it)| it.further_wrong.contains(&number));
            write_labels(f, "wrong", wrong)?;
            let either = mistakes().filter(|(_, it)| it.undecided.contains(&number));
            write_labels(f, "either", either)?;
        }
        f.write_str(&self.below)
    }
}

/// An answer with its tolerance, unless it is 0 and need not be said.
fn answer_line(answer: &Answer, tolerance: &Tolerance) -> String {
    let mut line = format!("= {}", text::answer(answer));
    match tolerance {
        Tolerance::Changes(changes) if changes.iter().all(|change| *change == 0.0) => {}
        _ => line += &text::tolerance(tolerance),
    }
    line
}

/// A word about mistakes, if there are any.
fn write_labels<'m>(
    f: &mut fmt::Formatter<'_>,
    word: &str,
    mistakes: impl Iterator<Item = (usize, &'m KnownMistake)>,
) -> fmt::Result {
    let mut labels = String::new();
    for (label, _) in mistakes {
        write!(labels, " m{label}")?;
    }
    if labels.is_empty() {
        return Ok(());
    }
    writeln!(f, "  {word}{labels}")
}

impl Record {
    /// The record of a text. The error is the first line that is no line of a record.
    pub fn read(text: &str) -> Result<Self, String> {
        let mut reader = Reader::default();
        for (number, line) in (1..).zip(text.lines()) {
            if reader.read_line(line).is_none() {
                let above = match &*reader.next.words {
                    "" => ", or the line of its `words` is not above it",
                    _ => "",
                };
                return Err(format!(
                    "line {number} is no line of a record{above}: {line}"
                ));
            }
        }
        Ok(Self {
            below: reader.next.above,
            ..reader.record
        })
    }

    /// The first question that has no answer yet.
    #[must_use]
    pub fn unanswered(&self) -> Option<&QuestionLine> {
        let mut questions = self.questions.iter();
        questions.find(|question| !question.right.is_recorded())
    }

    /// The questions of the file alone, for a program that must not know what is right.
    #[must_use]
    pub fn without_answers(self) -> Self {
        Self {
            mistakes: Vec::new(),
            ..self.with_answers(Vec::new())
        }
    }

    /// The same questions with these right answers, and none beyond their end.
    #[must_use]
    pub fn with_answers(mut self, right_answers: Vec<RightAnswer>) -> Self {
        let mut right_answers = right_answers.into_iter();
        for question in &mut self.questions {
            question.right = right_answers.next().unwrap_or_default();
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Answers of all kinds, also numbers that are hard to write and words with separators.
    #[test]
    fn a_record_is_read_as_it_was_written() {
        let hard = [0.1, -0.0, 5e-324, f64::MAX, f64::INFINITY];
        let words = Answer::words("x; y = 1 ~ \"\\\n");
        let answer = Answer::named("a · b", hard)
            .and("again", hard)
            .and("", words);
        let right = |tolerance| RightAnswer {
            answer: answer.clone(),
            tolerance,
        };
        let asked = Record::read("words the number {}\nsimple 1\nsimple 2\nother 3\n");
        let record = Record {
            mistakes: vec![KnownMistake {
                overlooks: "a = b; 1 ~ 2".to_owned(),
                answers: [(2, (answer.clone(), Tolerance::RoundingDecides))].into(),
                further_wrong: [0].into(),
                undecided: [1].into(),
            }],
            ..asked.unwrap().with_answers(vec![
                right(Tolerance::Changes(vec![0.0; 10])),
                right(Tolerance::RoundingDecides),
                right(Tolerance::Changes([hard, hard].concat())),
            ])
        };
        assert_eq!(Record::read(&record.to_string()), Ok(record));
    }

    /// A file as a lecturer leaves it: with a comment, and a question that has no answer yet.
    const FILE: &str = "\
mistake m1 a square overflows
words the vector {}

# Of which one is large.
simple 1 1e200 -0 = 1e200
  m1 = inf
simple 1e-308 inf 0.1
words the number {}, {} times
other 0.1 | 4294967295 = \"none\" ~ rounding decides
  either m1
# The end.
";

    #[test]
    fn a_file_of_questions_is_written_as_it_was_read() {
        let record = Record::read(FILE).unwrap();
        assert_eq!(record.to_string(), FILE);
        let [vector, new, number] = &record.questions[..] else {
            panic!("{record:?}");
        };
        let (input, question) = vector.read::<[f64; 3]>().unwrap();
        assert_eq!(
            input.map(f64::to_bits),
            [1.0, 1e200, -0.0].map(f64::to_bits)
        );
        assert_eq!(question.text, "the vector [1, 1e200, 0]");
        assert_eq!(record.unanswered(), Some(new));
        let (input, _) = new.read::<Vec<f64>>().unwrap();
        assert_eq!(input, [1e-308, f64::INFINITY, 0.1]);
        let (input, question) = number.read::<(f64, u32)>().unwrap();
        assert_eq!(input, (0.1, u32::MAX));
        assert_eq!((number.form, question.is_simple), (1, false));
    }

    #[test]
    fn a_file_without_answers_asks_the_same_questions() {
        // Of an empty list, such as the numbers of a mean, no argument is left.
        let file = FILE.replace("# The end.", "words the mean of {}\nsimple  = 0");
        let record = Record::read(&file).unwrap();
        let asked = record.without_answers();
        let text = asked.to_string();
        assert!(text.contains("\nsimple 1 1e200 -0\nsimple"), "{text}");
        assert_eq!(Record::read(&text), Ok(asked));
        let of_empty_list = "words the mean of {}\nsimple\nother\n";
        let record = Record::read(of_empty_list).unwrap();
        assert_eq!(record.to_string(), of_empty_list);
    }

    #[test]
    fn arguments_that_a_question_does_not_take_are_refused_with_its_words() {
        let mut line = Record::read(FILE).unwrap().questions.remove(0);
        for arguments in ["1 2", "1 2 3 4", "1 2 x", "1 2 | 3", "1 2 3 | 4", ""] {
            arguments.clone_into(&mut line.arguments);
            let error = line.read::<[f64; 3]>().unwrap_err();
            assert!(error.contains("\"the vector {}\""), "{error}");
        }
        "1 2 x".clone_into(&mut line.arguments);
        assert!(line.read::<Vec<f64>>().is_err());
        let above = ", or the line of its `words` is not above it";
        for (text, line, above) in [
            ("simple 1", 1, above),
            ("m1 = 0", 1, above),
            ("words the vector {}\nsmple 1 2 3", 2, ""),
        ] {
            let error = Record::read(text)
                .map(|record| record.questions)
                .unwrap_err();
            let says = format!("line {line} is no line of a record{above}: ");
            assert!(error.starts_with(&says), "{error}");
        }
    }
}
