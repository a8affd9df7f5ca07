//! `Answer`: the result of the code that is compared, as named numbers and words.

use std::mem;

use super::input::{Input, shown};

/// A result: named values.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer(pub(super) Vec<Part>);

/// Words, as `no hit`, which must be equal, and numbers, which may differ a little.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Part {
    pub name: &'static str,
    pub words: String,
    pub numbers: Vec<f64>,
}

impl Answer {
    pub(super) fn of(words: String, numbers: Vec<f64>) -> Self {
        let part = Part {
            words,
            numbers,
            ..Part::default()
        };
        Self(vec![part])
    }

    /// A decision in words, as `no hit`.
    #[must_use]
    pub fn words(words: impl Into<String>) -> Self {
        Self::of(words.into(), Vec::new())
    }

    /// A value with a name, as `t` of a hit.
    pub fn named(name: &'static str, value: impl Into<Self>) -> Self {
        let parts = value.into().0.into_iter();
        Self(parts.map(|part| Part { name, ..part }).collect())
    }

    /// This answer with one more named value.
    #[must_use]
    pub fn and(mut self, name: &'static str, value: impl Into<Self>) -> Self {
        self.0.extend(Self::named(name, value).0);
        self
    }

    /// Each number, with the magnitude of the value that it belongs to.
    pub(super) fn numbers(&self) -> impl Iterator<Item = (f64, f64)> {
        self.0.iter().flat_map(|part| {
            let largest = part.numbers.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
            // Nothing finite is near to infinity.
            let largest = largest.min(f64::MAX);
            part.numbers.iter().map(move |number| (*number, largest))
        })
    }

    /// Whether both have the same words, and the same count of numbers.
    fn decides_as(&self, other: &Self) -> bool {
        let decision = |part: &Part| (part.name, part.words.clone(), part.numbers.len());
        self.0.iter().map(decision).eq(other.0.iter().map(decision))
    }

    /// How far each number of another answer may be from this one: by `unit` of its
    /// magnitude, and by the changes of this answer to inputs that differ a little. None if
    /// one of those is another decision.
    pub(super) fn tolerances(
        &self,
        unit: f64,
        moved: impl Iterator<Item = [Self; 2]>,
    ) -> Option<Vec<f64>> {
        let own = self.numbers().map(|(_, magnitude)| magnitude * unit);
        let mut allowed: Vec<f64> = own.collect();
        for [more, less] in moved {
            (self.decides_as(&more) && self.decides_as(&less)).then_some(())?;
            let changed = self.numbers().zip(more.numbers().zip(less.numbers()));
            for (allowed, ((own, _), ((more, _), (less, _)))) in allowed.iter_mut().zip(changed) {
                *allowed += (more - own).abs().max((less - own).abs());
            }
        }
        Some(allowed)
    }

    /// The first value of this right answer from which `yours` differs by more than
    /// allowed, and what it is.
    pub(super) fn difference(&self, yours: &Self, allowed: &[f64]) -> Option<String> {
        let differ = |[right, yours]: [String; 2]| format!("must be {right}; yours is {yours}");
        if !self.decides_as(yours) {
            let all = |answer: &Self| answer.0.iter().map(Part::named).collect::<Vec<_>>();
            return Some(differ([self, yours].map(|answer| all(answer).join(", "))));
        }
        let mut allowed = allowed.iter();
        let mut parts = self.0.iter().zip(&yours.0);
        let (right, yours) = parts.find(|(right, yours)| {
            let numbers = right.numbers.iter().zip(&yours.numbers).zip(&mut allowed);
            // Nothing is near to NaN but NaN.
            let is_near = |((a, b), allowed): ((&f64, &f64), &f64)| {
                a == b || (a.is_nan() && b.is_nan()) || (a - b).abs() <= *allowed
            };
            numbers.filter(|pair| !is_near(*pair)).count() > 0
        })?;
        let mut values = [right, yours].map(|part| part.value(shown));
        if values[0] == values[1] {
            values = [right, yours].map(|part| part.value(|number| format!("{number:?}")));
        }
        let named = format!("{} {}", right.name, differ(values));
        Some(named.trim_start().to_owned())
    }
}

impl Part {
    fn value(&self, shown: impl Fn(f64) -> String) -> String {
        let numbers: Vec<_> = self.numbers.iter().map(|number| shown(*number)).collect();
        match numbers.as_slice() {
            [] => self.words.clone(),
            [number] => number.clone(),
            numbers => format!("[{}]", numbers.join(", ")),
        }
    }

    fn named(&self) -> String {
        let separator = if self.name.is_empty() { "" } else { " = " };
        format!("{}{separator}{}", self.name, self.value(shown))
    }
}

impl<T: Input> From<T> for Answer {
    fn from(mut value: T) -> Self {
        let mut numbers = Vec::new();
        value.for_each_number(&mut |number| numbers.push(mem::take(number)));
        Self::of(value.words().join(", "), numbers)
    }
}

impl<T: Into<Self>> From<Option<T>> for Answer {
    fn from(value: Option<T>) -> Self {
        value.map_or_else(|| Self::words("none"), Into::into)
    }
}
