//! `Outcome`: the result of a computation.

use std::{fmt, slice};

use common::Error;

/// The result of a computation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Outcome {
    /// A number, or a count.
    Number(f64),
    /// A point, a direction or a colour.
    Triple([f64; 3]),
    /// Yes or no: hit or not, lit or not.
    Flag(bool),
    /// Nothing: no hit, no direction.
    #[default]
    Nothing,
    /// The constructor refuses the arguments.
    Refused,
}

impl Outcome {
    /// Its numbers, if it has any.
    pub fn numbers(&self) -> &[f64] {
        match self {
            Self::Number(number) => slice::from_ref(number),
            Self::Triple(numbers) => numbers,
            _ => &[],
        }
    }

    /// The greatest distance between the numbers of two outcomes of the same kind.
    pub(super) fn distance(&self, other: &Self) -> Option<f64> {
        let (ours, others) = (self.numbers(), other.numbers());
        if ours.is_empty() || ours.len() != others.len() {
            return None;
        }
        let mut greatest = 0.0;
        for (a, b) in ours.iter().zip(others) {
            // Equal infinite numbers have no difference.
            let distance = if a == b { 0.0 } else { (a - b).abs() };
            // Unlike `max`, this keeps NaN.
            if distance > greatest || distance.is_nan() {
                greatest = distance;
            }
        }
        Some(greatest)
    }

    /// The greatest magnitude of its numbers.
    pub(super) fn magnitude(&self) -> f64 {
        self.numbers().iter().fold(0.0, |a, b| a.max(b.abs()))
    }
}

impl From<f64> for Outcome {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<usize> for Outcome {
    fn from(count: usize) -> Self {
        Self::Number(count as f64)
    }
}

impl From<[f64; 3]> for Outcome {
    fn from(numbers: [f64; 3]) -> Self {
        Self::Triple(numbers)
    }
}

impl From<bool> for Outcome {
    fn from(flag: bool) -> Self {
        Self::Flag(flag)
    }
}

impl<T: Into<Self>> From<Option<T>> for Outcome {
    fn from(outcome: Option<T>) -> Self {
        outcome.map_or(Self::Nothing, Into::into)
    }
}

impl<T: Into<Self>, E> From<Result<T, E>> for Outcome {
    fn from(outcome: Result<T, E>) -> Self {
        outcome.map_or(Self::Refused, Into::into)
    }
}

/// The outcome of a computation whose constructors may refuse their arguments.
pub fn tried<T: Into<Outcome>>(compute: impl FnOnce() -> Result<T, Error>) -> Outcome {
    compute().into()
}

/// The greatest magnitude of some numbers; NaN if one is NaN.
pub fn greatest(numbers: impl IntoIterator<Item = f64>) -> f64 {
    let mut greatest = 0.0;
    for number in numbers {
        if number.abs() > greatest || number.is_nan() {
            greatest = number.abs();
        }
    }
    greatest
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => f.write_str(&short(*number)),
            Self::Triple([x, y, z]) => write!(f, "({}, {}, {})", short(*x), short(*y), short(*z)),
            Self::Flag(true) => f.write_str("yes"),
            Self::Flag(false) => f.write_str("no"),
            Self::Nothing => f.write_str("none"),
            Self::Refused => f.write_str("refused"),
        }
    }
}

/// All digits of a number, with an exponent where it would otherwise be long.
fn short(number: f64) -> String {
    if number == 0.0 || !number.is_finite() || (1e-5..1e16).contains(&number.abs()) {
        format!("{number}")
    } else {
        format!("{number:e}")
    }
}
