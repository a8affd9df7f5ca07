//! `Tape`: answers as lines of text, in the order in which a check compares them.
//!
//! A check that reads the answers of the solution needs no solution; one that reads the
//! student's needs no student's code, which then cannot forge the verdict.

use std::vec;

use common::{Color, Error, Image, Settings};

use super::answer::Part;
use super::{Answer, Check, Input};

/// The beginning of each line, which sets it apart from what a program prints besides.
const MARK: char = '\u{1d}';
/// The line before a comparison.
const BEGIN: &str = "comparison";
/// Control characters between parts and values, and in the place of the end of a line.
const PART: &str = "\u{1e}";
const VALUE: &str = "\u{1f}";
const NEW_LINE: &str = "\u{1c}";

/// Answers that are computed, printed, too, or read.
#[derive(Default)]
pub(super) enum Tape {
    #[default]
    Computed,
    Printed,
    Read(vec::IntoIter<String>),
}

impl Tape {
    pub fn read(text: &str) -> Self {
        let lines = text.lines().filter_map(|line| line.strip_prefix(MARK));
        let lines: Vec<_> = lines.map(str::to_owned).collect();
        Self::Read(lines.into_iter())
    }

    /// Begins a comparison, so that one which stops early does not shift the next.
    pub fn begin(&mut self) {
        match self {
            Self::Computed => {}
            Self::Printed => print(BEGIN),
            Self::Read(lines) => drop(lines.find(|line| line == BEGIN)),
        }
    }

    /// The next answer; none at its end, or if there is no answer.
    pub fn next(&mut self, compute: impl FnOnce() -> Option<Answer>) -> Option<Answer> {
        match self {
            Self::Computed => compute(),
            Self::Printed => {
                let answer = compute();
                print(&answer.as_ref().map_or(String::new(), line));
                answer
            }
            Self::Read(lines) if lines.as_slice().first()? == BEGIN => None,
            Self::Read(lines) => answer(&lines.next()?),
        }
    }

    /// The next list of numbers.
    pub fn numbers(&mut self, compute: impl FnOnce() -> Option<Vec<f64>>) -> Option<Vec<f64>> {
        let answer = self.next(|| Some(Answer::of(String::new(), compute()?)))?;
        Some(answer.numbers().map(|(number, _)| number).collect())
    }
}

impl Check {
    /// Inputs that are found with the solution, and recorded where it is not handed out.
    pub fn recorded<I: Input + Default>(&mut self, inputs: impl FnOnce() -> Vec<I>) -> Vec<I> {
        let numbers = if let Some(known) = &mut self.known {
            known.inputs.next()
        } else {
            self.lesson.begin();
            let numbers = || inputs().iter().flat_map(Input::numbers).collect();
            self.lesson.numbers(|| Some(numbers()))
        };
        let numbers = numbers.unwrap_or_default();
        self.inputs.push(numbers.clone());
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
        self.yours.begin();
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

/// Prints a line. The student's code may have left one open.
fn print(line: &str) {
    println!("\n{MARK}{line}");
}

/// Name, words and numbers of each part. Digits of numbers are as many as tell them apart.
fn line(answer: &Answer) -> String {
    let part = |part: &Part| {
        let texts = [part.name, &part.words].map(|text| text.replace('\n', NEW_LINE));
        let numbers = part.numbers.iter().map(f64::to_string);
        let values: Vec<_> = texts.into_iter().chain(numbers).collect();
        values.join(VALUE)
    };
    answer.0.iter().map(part).collect::<Vec<_>>().join(PART)
}

/// The answer of a line; none if nobody has written it so.
fn answer(line: &str) -> Option<Answer> {
    let part = |part: &str| {
        let mut values = part.split(VALUE);
        let mut text = || Some(values.next()?.replace(NEW_LINE, "\n"));
        Some(Part {
            name: text()?.leak(),
            words: text()?,
            numbers: values.map(|n| n.parse().ok()).collect::<Option<_>>()?,
        })
    };
    line.split(PART)
        .map(part)
        .collect::<Option<_>>()
        .map(Answer)
}
