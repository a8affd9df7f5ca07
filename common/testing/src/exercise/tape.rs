//! `Tape`: answers as text, in the order in which a check compares them.
//!
//! A check that reads the answers of the solution needs no solution; one that reads the
//! student's needs no student's code, which then cannot forge the verdict.

use std::vec;

use common::{Color, Error, Image, Settings};

use super::answer::Part;
use super::{Answer, Check, Input};

/// The separators of ASCII: before all answers, which sets them apart from what a program prints
/// besides, and between answers, parts, and values.
const MARK: &str = "\u{1c}";
const ANSWER: &str = "\u{1d}";
const PART: &str = "\u{1e}";
const VALUE: &str = "\u{1f}";

/// Answers that are computed, kept, too, or read; none in the place of one that is not there.
#[derive(Default)]
pub(super) enum Tape {
    #[default]
    Computed,
    Kept(Vec<Option<Answer>>),
    Read(vec::IntoIter<Option<Answer>>),
}

impl Tape {
    /// The answers in the output of a program.
    pub fn read(text: &str) -> Self {
        let (_, answers) = text.split_once(MARK).unwrap_or_default();
        let answers: Vec<_> = answers.split(ANSWER).map(read).collect();
        Self::Read(answers.into_iter())
    }

    /// Prints the answers that are kept.
    pub fn print(&self) {
        if let Self::Kept(answers) = self {
            let answers: Vec<_> = answers.iter().map(|answer| text(answer.as_ref())).collect();
            print!("{MARK}{}", answers.join(ANSWER));
        }
    }

    /// The next answer.
    pub fn next(&mut self, compute: impl FnOnce() -> Option<Answer>) -> Option<Answer> {
        match self {
            Self::Computed => compute(),
            Self::Kept(answers) => {
                answers.push(compute());
                answers.last()?.clone()
            }
            Self::Read(answers) => answers.next()?,
        }
    }

    /// The next list of numbers.
    pub fn numbers(&mut self, compute: impl FnOnce() -> Option<Vec<f64>>) -> Option<Vec<f64>> {
        let answer = self.next(|| Some(Answer::of(String::new(), compute()?)))?;
        Some(answer.numbers().map(|(number, _)| number).collect())
    }
}

/// Name, words and numbers of each part. Digits of numbers are as many as tell them apart.
fn text(answer: Option<&Answer>) -> String {
    let part = |part: &Part| {
        let mut values = vec![part.name.to_owned(), part.words.clone()];
        values.extend(part.numbers.iter().map(f64::to_string));
        values.join(VALUE)
    };
    let parts = answer.map_or(&[][..], |answer| &answer.0).iter().map(part);
    parts.collect::<Vec<_>>().join(PART)
}

/// The answer of a text; none if nobody has written it so.
fn read(text: &str) -> Option<Answer> {
    let part = |text: &str| {
        let mut values = text.split(VALUE).map(str::to_owned);
        Some(Part {
            name: values.next()?.leak(),
            words: values.next()?,
            numbers: values.map(|n| n.parse().ok()).collect::<Option<_>>()?,
        })
    };
    text.split(PART)
        .map(part)
        .collect::<Option<_>>()
        .map(Answer)
}

impl Check {
    /// Inputs that are found with the solution, and recorded where it is not handed out.
    pub fn recorded<I: Input + Default>(&mut self, inputs: impl FnOnce() -> Vec<I>) -> Vec<I> {
        let numbers = || inputs().iter().flat_map(Input::numbers).collect();
        let numbers = self.lesson.numbers(|| Some(numbers())).unwrap_or_default();
        let inputs = Answer::of(String::new(), numbers.clone());
        self.inputs.push(Some(inputs));
        let each = numbers.chunks(I::default().numbers().len().max(1));
        each.map(|numbers| I::default().with_numbers(numbers))
            .collect()
    }

    /// The student's picture; black if it is to be read and is not there.
    pub(super) fn painted(
        &mut self,
        settings: &Settings,
        render: impl FnOnce(&Settings) -> Result<Image, Error>,
    ) -> Result<Image, Error> {
        let mut image = match self.yours {
            Tape::Read(_) => Image::black(settings.size)?,
            _ => render(settings)?,
        };
        let channels = image.pixels().iter().flat_map(|color| color.channels());
        let channels = channels.collect();
        let numbers = self.yours.numbers(|| Some(channels)).unwrap_or_default();
        for (pixel, [r, g, b]) in image.pixels_mut().iter_mut().zip(numbers.as_chunks().0) {
            *pixel = Color::new(*r, *g, *b);
        }
        Ok(image)
    }
}
