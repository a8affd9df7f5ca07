//! `Reader`: reads the lines of an exercise's file, of which each says more of the line above it.

use crate::answers::{Answer, KnownMistake, QuestionLine, Record, RightAnswer, Tolerance, text};

/// What the lines so far say.
#[derive(Default)]
pub struct Reader {
    pub record: Record,
    /// The labels of the mistakes, such as `m1`.
    labels: Vec<String>,
    /// What is known of the next question.
    pub next: QuestionLine,
}

impl Reader {
    /// Reads a line; none if it is no line of a record.
    pub fn read_line(&mut self, line: &str) -> Option<()> {
        let Self { record, next, .. } = self;
        if line.is_empty() || line.starts_with('#') {
            next.above.extend([line, "\n"]);
            return Some(());
        }
        let line = line.trim_start();
        let (word, rest) = line.split_once(' ').unwrap_or((line, ""));
        match word {
            "mistake" => {
                let (label, overlooks) = rest.split_once(' ')?;
                self.labels.push(label.to_owned());
                record.mistakes.push(KnownMistake {
                    overlooks: overlooks.to_owned(),
                    ..KnownMistake::default()
                });
            }
            "words" => {
                next.above.extend([line, "\n"]);
                next.form = record.questions.last().map_or(0, |last| last.form + 1);
                rest.clone_into(&mut next.words);
            }
            "simple" | "other" if !next.words.is_empty() => {
                let (arguments, answer) = rest.split_once(" = ").unwrap_or((rest, ""));
                next.is_simple = word == "simple";
                arguments.trim().clone_into(&mut next.arguments);
                next.right = RightAnswer::read(answer)?;
                record.questions.push(next.clone());
                next.above.clear();
            }
            "wrong" | "either" => {
                let question = record.questions.len().checked_sub(1)?;
                for label in rest.split(' ') {
                    let mistake = self.mistake(label)?;
                    let questions = match word {
                        "wrong" => &mut mistake.further_wrong,
                        _ => &mut mistake.undecided,
                    };
                    questions.insert(question);
                }
            }
            label => {
                let question = record.questions.len().checked_sub(1)?;
                let answer = read_answer(rest.strip_prefix("= ")?)?;
                self.mistake(label)?.answers.insert(question, answer);
            }
        }
        Some(())
    }

    /// The mistake of a label.
    fn mistake(&mut self, label: &str) -> Option<&mut KnownMistake> {
        let number = self.labels.iter().position(|known| known == label)?;
        self.record.mistakes.get_mut(number)
    }
}

impl RightAnswer {
    /// The right answer to a question; none where none is written.
    fn read(written: &str) -> Option<Self> {
        if written.is_empty() {
            return Some(Self::default());
        }
        let (answer, tolerance) = read_answer(written)?;
        Some(Self { answer, tolerance })
    }
}

/// An answer and its tolerance; if none is said, no number moves.
fn read_answer(mut text: &str) -> Option<(Answer, Tolerance)> {
    let answer = text::take_answer(&mut text)?;
    let tolerance = text::take_tolerance(&mut text).unwrap_or_else(|| Tolerance::none(&answer));
    Some((answer, tolerance))
}
