//! Answers and tolerances as text, of which every number has all its digits.

use std::fmt::Write;
use std::num::ParseFloatError;

use common::text::number;

use crate::answers::answer::{Part, Value};
use crate::answers::input::take_quoted;
use crate::answers::{Answer, Tolerance};

/// Between the parts of an answer, between name and value, and before a tolerance.
const PART: &str = "; ";
const NAME: &str = " = ";
const TOLERANCE: &str = " ~ ";

const ROUNDING_DECIDES: &str = "rounding decides";

/// Numbers, one after the other.
pub fn numbers(all: &[f64]) -> String {
    let all: Vec<_> = all.iter().map(|x| number(*x)).collect();
    all.join(" ")
}

/// The numbers of a text.
pub fn read_numbers(text: &str) -> Result<Vec<f64>, ParseFloatError> {
    text.split_whitespace().map(str::parse).collect()
}

/// Words in quotes, on one line.
fn quoted(words: &str) -> String {
    let words = words.replace('\\', "\\\\").replace('"', "\\\"");
    format!("\"{}\"", words.replace('\n', "\\n"))
}

/// An answer, such as `t = 3; normal = 0 0 1` or `"no hit"`. A value that is equal to the one
/// before is written as the name of that one, such as `face = normal`.
pub fn answer(answer: &Answer) -> String {
    let mut text = String::new();
    for (index, Part { name, value }) in answer.parts.iter().enumerate() {
        if !text.is_empty() {
            text += PART;
        }
        if !name.is_empty() {
            text.extend([name, NAME]);
        }
        let before = index.checked_sub(1).map(|index| &answer.parts[index]);
        match value {
            Value::Words(words) => text += &quoted(words),
            Value::Numbers(all) => match before.filter(|before| before.is_repeated_by(all)) {
                Some(before) => text += &before.name,
                None => text += &numbers(all),
            },
        }
    }
    text
}

impl Part {
    /// Whether these are its numbers, bit for bit, and it has a name that says so.
    fn is_repeated_by(&self, numbers: &[f64]) -> bool {
        let Value::Numbers(own) = &self.value else {
            return false;
        };
        let bits = |numbers: &[f64]| numbers.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        !self.name.is_empty() && numbers.len() > 1 && bits(own) == bits(numbers)
    }
}

/// Takes an answer from the beginning of a text.
pub fn take_answer(text: &mut &str) -> Option<Answer> {
    let mut parts: Vec<Part> = Vec::new();
    loop {
        let mut name = "";
        if !text.starts_with('"')
            && let Some((before, after)) = text.split_once(NAME)
            && !before.contains([';', '~', '"'])
        {
            (name, *text) = (before, after);
        }
        let value = if text.starts_with('"') {
            Value::Words(take_quoted(text)?)
        } else {
            let end = text.find(PART).unwrap_or(text.len());
            let end = end.min(text.find(TOLERANCE).unwrap_or(end));
            let (all, rest) = text.split_at(end);
            *text = rest;
            match parts.last() {
                Some(Part { name, value }) if name == all => value.clone(),
                _ => Value::Numbers(read_numbers(all).ok()?),
            }
        };
        let name = name.to_owned();
        parts.push(Part { name, value });
        let Some(rest) = text.strip_prefix(PART) else {
            return Some(Answer { parts });
        };
        *text = rest;
    }
}

/// A tolerance after an answer: how far its numbers move, or that rounding decides.
pub fn tolerance(tolerance: &Tolerance) -> String {
    let mut text = TOLERANCE.to_owned();
    match tolerance {
        Tolerance::RoundingDecides => text += ROUNDING_DECIDES,
        Tolerance::Changes(changes) => {
            for (index, change) in changes.iter().enumerate() {
                let space = if index == 0 { "" } else { " " };
                // Writing to a text does not fail.
                let _ = write!(text, "{space}{}", number(*change));
            }
        }
    }
    text
}

/// Takes a tolerance from the beginning of a text; none if there is no more.
pub fn take_tolerance(text: &mut &str) -> Option<Tolerance> {
    let rest = text.strip_prefix(TOLERANCE)?;
    *text = "";
    Some(match rest {
        ROUNDING_DECIDES => Tolerance::RoundingDecides,
        numbers => Tolerance::Changes(read_numbers(numbers).ok()?),
    })
}
