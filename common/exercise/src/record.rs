//! `Record`: the right answers of an exercise and those of known mistakes, in a text file.
//!
//! A line begins with the word that says what it is. `?` has the key of the next question, after `=`
//! the right answer to it, and after `~` how far its numbers may move, beside their own rounding:
//! nothing where they must not, and `rounding decides` where every answer is right. `mistake` begins
//! a known mistake: the numbers of the rows, from 1, in which code with this mistake is `wrong`, or
//! in which `either` answer is possible; and its answers to some questions.

use std::collections::BTreeSet;
use std::fmt;

use crate::{Answer, Mistake, Row, Tolerance, text};

/// Right answers and known mistakes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Record {
    /// The right answers.
    pub rows: Vec<Row>,
    /// The known mistakes.
    pub mistakes: Vec<Mistake>,
}

impl fmt::Display for Record {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for row in &self.rows {
            write!(f, "? {} = {}", row.key, text::answer(&row.answer))?;
            write_tolerance(f, &row.tolerance)?;
            writeln!(f)?;
        }
        for mistake in &self.mistakes {
            writeln!(f, "mistake {}", mistake.overlooks)?;
            for (word, numbers) in [
                ("wrong", &mistake.further_wrong_rows),
                ("either", &mistake.undecided_rows),
            ] {
                if !numbers.is_empty() {
                    writeln!(f, "{word} {}", ranges(numbers))?;
                }
            }
            for (number, (answer, tolerance)) in &mistake.answers {
                write!(f, "{} = {}", number + 1, text::answer(answer))?;
                write_tolerance(f, tolerance)?;
                writeln!(f)?;
            }
        }
        Ok(())
    }
}

/// Writes a tolerance, unless it is 0 and need not be said.
fn write_tolerance(f: &mut fmt::Formatter<'_>, tolerance: &Tolerance) -> fmt::Result {
    let is_none = |changes: &[f64]| changes.iter().all(|change| *change == 0.0);
    match tolerance {
        Tolerance::Changes(changes) if is_none(changes) => Ok(()),
        _ => f.write_str(&text::tolerance(tolerance)),
    }
}

impl Record {
    /// The record of a text. The error is the first line that is no line of a record.
    pub fn read(text: &str) -> Result<Self, String> {
        let mut record = Self::default();
        for (number, line) in (1..).zip(text.lines()) {
            record
                .read_line(line)
                .ok_or_else(|| format!("line {number} is no line of a record: {line}"))?;
        }
        Ok(record)
    }

    fn read_line(&mut self, line: &str) -> Option<()> {
        let (word, mut rest) = line.split_once(' ')?;
        match word {
            "?" => {
                let (key, mut rest) = rest.split_once(" = ")?;
                let answer = text::take_answer(&mut rest)?;
                let tolerance = read_tolerance(&mut rest, &answer);
                self.rows.push(Row {
                    key: key.to_owned(),
                    answer,
                    tolerance,
                });
            }
            "mistake" => self.mistakes.push(Mistake {
                overlooks: rest.to_owned(),
                ..Mistake::default()
            }),
            "wrong" => self.mistakes.last_mut()?.further_wrong_rows = read_ranges(rest)?,
            "either" => self.mistakes.last_mut()?.undecided_rows = read_ranges(rest)?,
            number => {
                let number = number.parse::<usize>().ok()?.checked_sub(1)?;
                rest = rest.strip_prefix("= ")?;
                let answer = text::take_answer(&mut rest)?;
                let tolerance = read_tolerance(&mut rest, &answer);
                let answers = &mut self.mistakes.last_mut()?.answers;
                answers.insert(number, (answer, tolerance));
            }
        }
        Some(())
    }
}

/// Takes a tolerance from the beginning of a text; if none is said, no number moves.
fn read_tolerance(text: &mut &str, answer: &Answer) -> Tolerance {
    let none = || Tolerance::Changes(answer.roundings(0.0).map(|_| 0.0).collect());
    text::take_tolerance(text).unwrap_or_else(none)
}

/// Numbers of rows, from 1, such as `3 7-9`.
fn ranges(numbers: &BTreeSet<usize>) -> String {
    let numbers: Vec<_> = numbers.iter().map(|number| number + 1).collect();
    let ranges = numbers.chunk_by(|a, b| a + 1 == *b);
    let ranges = ranges.map(|range| match range {
        [first, .., last] => format!("{first}-{last}"),
        _ => range[0].to_string(),
    });
    ranges.collect::<Vec<_>>().join(" ")
}

fn read_ranges(text: &str) -> Option<BTreeSet<usize>> {
    let mut numbers = BTreeSet::new();
    for range in text.split(' ') {
        let (first, last) = range.split_once('-').unwrap_or((range, range));
        let [first, last]: [usize; 2] = [first.parse().ok()?, last.parse().ok()?];
        numbers.extend(first.checked_sub(1)?..last);
    }
    Some(numbers)
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
        let row = |tolerance| Row {
            key: "7f03a1".to_owned(),
            answer: answer.clone(),
            tolerance,
        };
        let record = Record {
            rows: vec![
                row(Tolerance::Changes(vec![0.0; 10])),
                row(Tolerance::RoundingDecides),
                row(Tolerance::Changes([hard, hard].concat())),
            ],
            mistakes: vec![Mistake {
                overlooks: "a = b; 1 ~ 2".to_owned(),
                answers: [(2, (answer.clone(), Tolerance::RoundingDecides))].into(),
                further_wrong_rows: [0, 4, 5, 6].into(),
                undecided_rows: [1].into(),
            }],
        };
        assert_eq!(Record::read(&record.to_string()), Ok(record));
    }
}
