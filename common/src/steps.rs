//! `steps`: the steps of a computation.
//!
//! They follow one another as the headings and paragraphs of a text do: the level of a step says
//! to which earlier step it belongs.

mod record;

pub use record::*;

use crate::pixel_trace::digits;

/// A step of a computation.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// The number of steps that this one is a part of.
    pub level: usize,
    /// The kind of the step, a word for programs.
    pub kind: &'static str,
    /// The name of the step, which distinguishes it from the steps beside it.
    pub name: String,
    /// The outcome in words; may be empty.
    pub outcome: String,
    /// Numbers, points, vectors and colours, by the symbols of the book.
    pub values: Vec<(&'static str, Vec<f64>)>,
    /// The section of the book that explains the step: the page below `book/src`, and the anchor
    /// that mdBook makes of the heading.
    pub section: &'static str,
}

impl Step {
    /// A step without outcome and values.
    pub fn new(kind: &'static str, name: impl Into<String>, section: &'static str) -> Self {
        Self {
            level: 0,
            kind,
            name: name.into(),
            outcome: String::new(),
            values: Vec::new(),
            section,
        }
    }

    /// This step with one more value.
    #[must_use]
    pub fn with(mut self, symbol: &'static str, value: impl Into<Vec<f64>>) -> Self {
        self.values.push((symbol, value.into()));
        self
    }

    /// The outcome, and each value with its symbol.
    pub fn words(&self) -> impl Iterator<Item = String> {
        let values = self.values.iter();
        let values = values.map(|(symbol, value)| format!("{symbol} {}", digits(value)));
        let outcome = Some(self.outcome.clone()).filter(|outcome| !outcome.is_empty());
        outcome.into_iter().chain(values)
    }

    /// The value of this symbol, if it has this many numbers.
    #[must_use]
    pub fn value<const N: usize>(&self, symbol: &str) -> Option<[f64; N]> {
        let value = self.values.iter().find(|(name, _)| *name == symbol);
        value.and_then(|(_, value)| value.as_slice().try_into().ok())
    }
}

/// The kind of a ray from the camera.
pub const RAY: &str = "ray";
/// The kind of a ray that a surface mirrors.
pub const REFLECTED: &str = "reflected ray";
/// The kind of a test of an object for a hit.
pub const TEST: &str = "test";
/// The kind of the nearest hit, which is shaded; and the outcome of a test that finds a hit.
pub const HIT: &str = "hit";
/// The kind of a light at a hit.
pub const LIGHT: &str = "light";
/// The name of the step at which a ray without a hit takes the background.
pub const NO_HIT: &str = "no hit: the background";
