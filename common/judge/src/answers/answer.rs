//! `Answer`: the result of the code that is asked, as named numbers and words.

use std::mem;

use crate::answers::input::{Input, readable};

/// A result: values, each with a name or alone.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Answer {
    pub(crate) parts: Vec<Part>,
}

/// A value of an answer.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Part {
    /// The name, such as `t` of a hit; empty for a value alone.
    pub name: String,
    pub value: Value,
}

/// Words, such as `no hit`, which must be equal, or numbers, which may differ a little.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Value {
    Words(String),
    Numbers(Vec<f64>),
}

impl Answer {
    fn of(value: Value) -> Self {
        let name = String::new();
        Self {
            parts: vec![Part { name, value }],
        }
    }

    /// A decision in words, such as `no hit`.
    #[must_use]
    pub fn words(words: impl Into<String>) -> Self {
        Self::of(Value::Words(words.into()))
    }

    /// A value with a name, such as `t` of a hit.
    pub fn named(name: &str, value: impl Into<Self>) -> Self {
        let mut answer = value.into();
        for part in &mut answer.parts {
            name.clone_into(&mut part.name);
        }
        answer
    }

    /// This answer with one more named value.
    #[must_use]
    pub fn and(mut self, name: &str, value: impl Into<Self>) -> Self {
        self.parts.extend(Self::named(name, value).parts);
        self
    }

    /// The number of this name, if there is one.
    #[must_use]
    pub fn number(&self, name: &str) -> Option<f64> {
        let part = self.parts.iter().find(|part| part.name == name)?;
        part.value.numbers().first().copied()
    }

    /// Each number, with the magnitude of the value that it belongs to.
    fn numbers(&self) -> impl Iterator<Item = (f64, f64)> {
        self.parts.iter().flat_map(|part| {
            let numbers = part.value.numbers();
            let largest = numbers.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
            // Nothing finite is near to infinity.
            let largest = largest.min(f64::MAX);
            numbers.iter().map(move |number| (*number, largest))
        })
    }

    /// By how much each number may differ from it through rounding alone: by `unit` of the
    /// magnitude of its value.
    pub(crate) fn roundings(&self, unit: f64) -> impl Iterator<Item = f64> {
        self.numbers().map(move |(_, magnitude)| magnitude * unit)
    }

    /// Whether both have the same words, and the same count of numbers.
    pub(crate) fn has_same_form(&self, other: &Self) -> bool {
        let mut pairs = self.parts.iter().zip(&other.parts);
        self.parts.len() == other.parts.len() && pairs.all(|(a, b)| a.has_same_form(b))
    }

    /// How far each number moves from this answer to answers at inputs that differ a little:
    /// the sum of the larger changes. None if one of those is another decision.
    pub(crate) fn sum_of_movements(
        &self,
        moved: impl Iterator<Item = [Self; 2]>,
    ) -> Option<Vec<f64>> {
        let mut changes = vec![0.0; self.numbers().count()];
        for [more, less] in moved {
            if !(self.has_same_form(&more) && self.has_same_form(&less)) {
                return None;
            }
            let moved = more.numbers().zip(less.numbers());
            for ((change, (own, _)), ((more, _), (less, _))) in
                changes.iter_mut().zip(self.numbers()).zip(moved)
            {
                *change += (more - own).abs().max((less - own).abs());
            }
        }
        Some(changes)
    }

    /// The first value of this right answer from which `yours` differs by more than
    /// allowed, and what it is.
    pub(crate) fn difference(&self, yours: &Self, allowed: &[f64]) -> Option<String> {
        let differ = |[right, yours]: [String; 2]| format!("must be {right}; yours is {yours}");
        if !self.has_same_form(yours) {
            let mut pairs = self.parts.iter().zip(&yours.parts);
            if let Some((right, yours)) = pairs.find(|(a, b)| !a.has_same_form(b))
                && right.name == yours.name
                && !right.name.is_empty()
            {
                let values = [right, yours].map(|part| part.value.in_words(readable));
                return Some(format!("{} {}", right.name, differ(values)));
            }
            let all = |answer: &Self| {
                let parts = answer.parts.iter().map(Part::with_name);
                parts.collect::<Vec<_>>().join(", ")
            };
            return Some(differ([self, yours].map(all)));
        }
        let mut allowed = allowed.iter();
        let mut parts = self.parts.iter().zip(&yours.parts);
        let (right, yours) = parts.find(|(right, yours)| {
            let numbers = right.value.numbers().iter().zip(yours.value.numbers());
            let far = numbers.zip(&mut allowed).filter(|((a, b), allowed)| {
                // Nothing is near to NaN but NaN.
                let is_near = a == b || (a.is_nan() && b.is_nan()) || (*a - *b).abs() <= **allowed;
                !is_near
            });
            far.count() > 0
        })?;
        let mut values = [right, yours].map(|part| part.value.in_words(readable));
        if values[0] == values[1] {
            values = [right, yours].map(|part| part.value.in_words(|x| format!("{x:?}")));
        }
        let named = format!("{} {}", right.name, differ(values));
        Some(named.trim_start().to_owned())
    }
}

impl Part {
    fn has_same_form(&self, other: &Self) -> bool {
        let is_equal = match (&self.value, &other.value) {
            (Value::Words(a), Value::Words(b)) => a == b,
            (Value::Numbers(a), Value::Numbers(b)) => a.len() == b.len(),
            _ => false,
        };
        is_equal && self.name == other.name
    }

    fn with_name(&self) -> String {
        let separator = if self.name.is_empty() { "" } else { " = " };
        format!("{}{separator}{}", self.name, self.value.in_words(readable))
    }
}

impl Value {
    fn numbers(&self) -> &[f64] {
        match self {
            Self::Words(_) => &[],
            Self::Numbers(numbers) => numbers,
        }
    }

    fn in_words(&self, number_text: impl Fn(f64) -> String) -> String {
        match self {
            Self::Words(words) if words.is_empty() => "nothing".to_owned(),
            Self::Words(words) => words.clone(),
            Self::Numbers(numbers) => {
                let numbers: Vec<_> = numbers.iter().map(|number| number_text(*number)).collect();
                match numbers.as_slice() {
                    [number] => number.clone(),
                    numbers => format!("[{}]", numbers.join(", ")),
                }
            }
        }
    }
}

/// The numbers of a value; of one that has none, such as a whole number, its words.
impl<T: Input> From<T> for Answer {
    fn from(mut value: T) -> Self {
        let mut numbers = Vec::new();
        value.for_each_number(&mut |number| numbers.push(mem::take(number)));
        Self::of(if numbers.is_empty() {
            Value::Words(value.words().join(", "))
        } else {
            Value::Numbers(numbers)
        })
    }
}

impl<T: Into<Self>> From<Option<T>> for Answer {
    fn from(value: Option<T>) -> Self {
        value.map_or_else(|| Self::words("none"), Into::into)
    }
}

/// An assertion of an example, with words about it, of numbers that formulas may round differently.
///
/// # Panics
///
/// Panics with the words and the difference if there is one.
#[track_caller]
pub fn assert_close_about(about: &str, yours: impl Into<Answer>, right: impl Into<Answer>) {
    let (yours, right) = (yours.into(), right.into());
    let allowed = right.numbers().map(|(_, largest)| largest.max(1e-3) * 1e-9);
    let difference = right.difference(&yours, &allowed.collect::<Vec<_>>());
    if let Some(difference) = difference {
        panic!("{about}: {difference}");
    }
}

/// As the macro of this name without words, which files begun from an earlier starter call.
///
/// # Panics
///
/// Panics with the difference if there is one.
#[track_caller]
pub fn assert_close(yours: impl Into<Answer>, right: impl Into<Answer>) {
    assert_close_about("an example", yours, right);
}

/// An assertion of an example, with words about it or its own: `assert_close!(1.0 + 1.0, 2.0, "a sum")`.
/// Formulas may round its numbers differently.
#[macro_export]
macro_rules! assert_close {
    ($yours:expr, $right:expr $(,)?) => {
        $crate::answers::assert_close_about(stringify!($yours), $yours, $right)
    };
    ($yours:expr, $right:expr, $about:expr $(,)?) => {
        $crate::answers::assert_close_about($about, $yours, $right)
    };
}
