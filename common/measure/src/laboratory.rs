//! `Laboratory`: the experiments and extreme cases of a stage.

use common::Stage;

use crate::Effort;
use crate::experiment::Experiment;
use crate::extremes::Case;

/// The laboratory of a stage.
pub struct Laboratory {
    /// The stage.
    pub stage: Stage,
    /// The experiments about error against run time.
    pub experiments: fn() -> Vec<Experiment<'static>>,
    /// The stiff and extreme cases.
    pub extremes: fn(Effort) -> Vec<Case>,
}
