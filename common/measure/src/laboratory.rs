//! `Laboratory`: the experiments and extreme cases of a stage.

use common::{Error, Stage};

use crate::Effort;
use crate::experiment::Experiment;
use crate::extremes::Case;

/// Searches for the worst input of the formulas of a shape.
pub type Search = fn(&str) -> Result<String, Error>;

/// The laboratory of a stage.
pub struct Laboratory {
    /// The stage.
    pub stage: Stage,
    /// The experiments about error against run time.
    pub experiments: fn() -> Vec<Experiment<'static>>,
    /// The stiff and extreme cases.
    pub extremes: fn(Effort) -> Vec<Case>,
    /// The search for worst inputs, which returns them in words, if the stage knows any shape.
    pub search: Option<Search>,
}
