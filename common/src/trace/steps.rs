//! `steps`: the steps of a computation, which are counted or written down.
//!
//! They follow one another as the headings and paragraphs of a text do: the level of a step says
//! to which earlier step it belongs.

mod chosen_pixel;
mod counts;
mod kind;
mod recorder;
mod trace;

use std::fmt;

pub use chosen_pixel::{trace_chosen, with_chosen_pixel};
pub use counts::{Counts, count, counted, is_counting};
pub use kind::StepKind;
pub use recorder::last;
pub use trace::{heading, inside, is_tracing, push, so_far, traced, untraced};

use crate::pixel_trace::digits;

/// A step of a computation.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// The number of steps that this one is a part of.
    pub level: usize,
    /// The kind of the step.
    pub kind: StepKind,
    /// The number, from 1, of the sample, object, light or reflected ray that the step is about.
    pub number: Option<usize>,
    /// The name of the step, which distinguishes it from the steps beside it.
    pub name: String,
    /// The type of the object, the light or the material that the step is about; empty if it is about none.
    pub about: String,
    /// The outcome of a test or of a light.
    pub outcome: Outcome,
    /// Numbers, points, vectors and colours, by the symbols of the book.
    pub values: Vec<(&'static str, Vec<f64>)>,
    /// The section of the book that explains the step: the page below `book/src`, and the anchor
    /// that mdBook makes of the heading.
    pub section: &'static str,
}

impl Step {
    /// A step without number, outcome and values.
    pub fn new(kind: StepKind, name: impl Into<String>, section: &'static str) -> Self {
        Self {
            level: 0,
            kind,
            number: None,
            name: name.into(),
            about: String::new(),
            outcome: Outcome::None,
            values: Vec::new(),
            section,
        }
    }

    /// This step about something of a type.
    #[must_use]
    pub fn about(mut self, type_name: impl Into<String>) -> Self {
        self.about = type_name.into();
        self
    }

    /// This step about the thing of a number.
    #[must_use]
    pub fn numbered(mut self, number: usize) -> Self {
        self.number = Some(number);
        self
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
        let outcome = Some(self.outcome.to_string()).filter(|outcome| !outcome.is_empty());
        outcome.into_iter().chain(values)
    }

    /// The value of this symbol, if it has this many numbers.
    #[must_use]
    pub fn value<const N: usize>(&self, symbol: &str) -> Option<[f64; N]> {
        let value = self.values.iter().find(|(name, _)| *name == symbol);
        value.and_then(|(_, value)| value.as_slice().try_into().ok())
    }
}

/// How a test of an object ends, or the way from a light to a hit.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Outcome {
    /// Nothing is to say.
    #[default]
    None,
    /// The ray hits the object: the nearest so far.
    Hit,
    /// The ray hits the object, but another one before.
    FartherHit,
    /// The ray hits the object, but outside of the interval.
    BeyondInterval,
    /// The line of the ray hits the object, but behind the ray's origin.
    BehindOrigin,
    /// The line of the ray misses the object.
    Missed,
    /// The light arrives.
    Arrives,
    /// The object of this name lies before the light.
    BlockedBy(String),
    /// The light shines on the back of the surface.
    BehindSurface,
    /// The light does not shine at this place, even without objects in between.
    Dark,
}

/// The outcome in words; empty for none.
impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::None => "",
            Self::Hit => "hit",
            Self::FartherHit => "farther than the nearest hit",
            Self::BeyondInterval => "beyond the interval",
            Self::BehindOrigin => "behind the origin of the ray",
            Self::Missed => "beside the ray",
            Self::Arrives => "arrives",
            Self::BlockedBy(object) => return write!(f, "blocked by {object}"),
            Self::BehindSurface => "behind the surface",
            Self::Dark => "does not shine here",
        })
    }
}

/// The name of a value's type, with which its `Debug` output begins.
pub fn type_name(value: &(impl fmt::Debug + ?Sized)) -> String {
    /// Keeps the first word, and ends the output behind it.
    struct FirstWord(String);

    impl fmt::Write for FirstWord {
        fn write_str(&mut self, text: &str) -> fmt::Result {
            let end = text.find(|c: char| !c.is_alphanumeric());
            self.0 += &text[..end.unwrap_or(text.len())];
            end.map_or(Ok(()), |_| Err(fmt::Error))
        }
    }

    let mut name = FirstWord(String::new());
    // The error says that the word is complete.
    let _ = fmt::write(&mut name, format_args!("{value:?}"));
    name.0
}
