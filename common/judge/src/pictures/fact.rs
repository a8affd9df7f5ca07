//! `Fact`: what a picture must show, as a row of a sheet: words, what is measured where, and the value that
//! follows from theory.

mod read;

use crate::pictures::quantity::{Exact, Quantity};
use crate::pictures::run::Run;
use crate::pictures::values::Channel;

/// What a picture must show.
#[derive(Debug)]
pub struct Fact {
    /// One word.
    pub name: String,
    /// The fact in words.
    pub says: String,
    /// The picture, whose copy is marked: of several the last.
    pub(crate) run: Run,
    pub(crate) channel: Option<Channel>,
    pub(crate) quantity: Quantity,
    /// The right value.
    pub value: f64,
    /// The formula of the right value.
    pub formula: String,
    /// How far from it values are right, too.
    pub within: f64,
    /// Whether all lower values are.
    pub or_less: bool,
    /// Why this tolerance.
    pub(crate) because: String,
    pub(crate) hint: String,
}

impl Fact {
    /// Whether this value is right.
    pub(crate) fn is_right(&self, value: f64) -> bool {
        let above = value - self.value;
        above <= self.within && (self.or_less || -above <= self.within)
    }

    /// The runs that the fact needs, in the order in which their pictures are drawn.
    pub(crate) fn runs(&self) -> Vec<&Run> {
        let mut runs = match &self.quantity {
            Quantity::Growth { runs, .. } | Quantity::Slope { runs, .. } => runs.iter().collect(),
            _ => vec![&self.run],
        };
        match &self.quantity {
            Quantity::Same(other)
            | Quantity::Spread {
                exact: Exact::Run(other),
                ..
            }
            | Quantity::Slope {
                exact: Exact::Run(other),
                ..
            } => runs.push(other),
            _ => {}
        }
        runs
    }
}
