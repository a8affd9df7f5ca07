//! `Outcome`: the result of a computation.

use std::{fmt, slice};

use common::Error;

/// The result of a computation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// A number, or a count.
    Number(f64),
    /// A point, a direction or a colour.
    Triple([f64; 3]),
    /// Yes or no: hit or not, lit or not.
    Flag(bool),
    /// Nothing: no hit, no direction.
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
        let (a, b) = (self.numbers(), other.numbers());
        let apart = |(a, b): (&f64, &f64)| if a == b { 0.0 } else { (a - b).abs() };
        // Unlike `max`, this keeps NaN.
        let greatest = |a: f64, b: f64| if a.is_nan() || a > b { a } else { b };
        let all = a.iter().zip(b).map(apart).reduce(greatest);
        all.filter(|_| a.len() == b.len())
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

/// Of some trials, the number for which each of two decisions is wrong, ours and the
/// protocol's.
pub fn wrong<T, E>(
    trials: impl IntoIterator<Item = T>,
    are_wrong: impl Fn(T) -> Result<[bool; 2], E>,
) -> Result<[usize; 2], E> {
    let add = |counts: [usize; 2], trial| {
        let are_wrong = are_wrong(trial)?;
        Ok([0, 1].map(|i| counts[i] + usize::from(are_wrong[i])))
    };
    trials.into_iter().try_fold([0; 2], add)
}

/// The greatest magnitude of some numbers; NaN if one is NaN.
pub fn greatest(numbers: impl IntoIterator<Item = f64>) -> f64 {
    let magnitudes = numbers.into_iter().map(f64::abs);
    magnitudes.fold(0.0, |a, b| if b > a || b.is_nan() { b } else { a })
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
