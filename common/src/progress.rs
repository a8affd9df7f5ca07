//! `Progress`: follows a rendering while it runs.

use std::sync::{Mutex, PoisonError};

use crate::{Color, SamplingReport};

/// Follows a rendering from row to row. Called from all of its threads.
pub trait Progress: Sync {
    /// Row `y`, counted from the top, is finished. Its colours are computed only if the
    /// iterator is used.
    fn row(&self, y: u32, pixels: &mut dyn Iterator<Item = Color>);

    /// This fraction of the work is done, from 0 to 1. Where it is told, rows do not tell it: they
    /// are painted again, nobody knows how often.
    fn done(&self, _: f64) {}

    /// Adaptive sampling of the picture has ended with this result.
    fn sampled(&self, _: &SamplingReport) {}

    /// True once the picture is no longer needed: no further row is begun.
    fn stopped(&self) -> bool {
        false
    }
}

/// Ignores the progress.
impl Progress for () {
    fn row(&self, _: u32, _: &mut dyn Iterator<Item = Color>) {}
}

/// Keeps the result of adaptive sampling.
impl Progress for Mutex<SamplingReport> {
    fn row(&self, _: u32, _: &mut dyn Iterator<Item = Color>) {}

    fn sampled(&self, sampled: &SamplingReport) {
        *self.lock().unwrap_or_else(PoisonError::into_inner) = *sampled;
    }
}
