//! `Theory`: what theory says about the error of a fact's pictures at each number of samples.

use crate::pictures::fact::Fact;
use crate::pictures::fitted_slope::Axis;
use crate::pictures::quantity::Quantity;
use crate::pictures::run::Run;
use crate::pictures::sheet::{RequestedPicture, Sheet};

/// What theory says about the errors behind a slope.
#[derive(Debug)]
pub struct Theory {
    /// Whose errors they are, such as independent random rays.
    pub name: String,
    /// The errors, one for each number of samples.
    pub errors: Vec<f64>,
    /// Their formula.
    pub formula: String,
    /// Mistakes that leave these pixels as they are.
    pub unseen: String,
    /// The number of tests that white stands for, where a picture shows no light but tests, and samples are
    /// balls. Of such errors only the shape is known.
    pub tests: Option<f64>,
}

/// The errors of a program's pictures, and those of theory.
#[derive(Debug)]
pub struct Precision<'a> {
    /// The fact that asks their slope.
    pub fact: &'a Fact,
    /// What theory says.
    pub theory: &'a Theory,
    /// What the logarithm of the error is a straight line over.
    pub axis: Axis,
    /// The picture that is drawn.
    pub picture: &'a RequestedPicture,
    /// Its runs, from few samples to many.
    pub runs: &'a [Run],
    /// The number of columns.
    pub width: usize,
    /// The errors of each run.
    pub points: Vec<PixelErrors>,
}

/// The errors of a picture.
#[derive(Debug)]
pub struct PixelErrors {
    /// Its samples.
    pub samples: u32,
    /// The time of the run.
    pub seconds: f64,
    /// The differences from what is exact, row by row.
    pub errors: Vec<f64>,
}

impl Fact {
    /// What theory says about its errors.
    pub(crate) const fn theory(&self) -> Option<&Theory> {
        match &self.quantity {
            Quantity::Slope { theory, .. } => theory.as_ref(),
            _ => None,
        }
    }
}

impl Sheet {
    /// The fact of which theory knows the errors.
    pub(crate) fn fact_with_theory(&self) -> Option<&Fact> {
        self.facts.iter().find(|fact| fact.theory().is_some())
    }
}
