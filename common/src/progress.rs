//! `Progress`: follows a rendering while it goes on.

use std::sync::{Mutex, PoisonError};

use crate::{Color, Sampled};

/// Follows a rendering from row to row. Called from all of its threads.
pub trait Progress: Sync {
    /// Row `y`, counted from the top, is finished. Its colours are worked out for those
    /// who look at them.
    fn row(&self, y: u32, pixels: &mut dyn Iterator<Item = Color>);

    /// This many rows will be painted once more.
    fn more_rows(&self, _: u32) {}

    /// The picture, or this part of it, is sampled as exactly as was asked for.
    fn sampled(&self, _: &Sampled) {}

    /// True once the picture is not wanted any more: no further row is begun.
    fn stopped(&self) -> bool {
        false
    }
}

/// Nobody follows.
impl Progress for () {
    fn row(&self, _: u32, _: &mut dyn Iterator<Item = Color>) {}
}

/// Adds up the samples of the parts of a picture.
impl Progress for Mutex<Sampled> {
    fn row(&self, _: u32, _: &mut dyn Iterator<Item = Color>) {}

    fn sampled(&self, part: &Sampled) {
        *self.lock().unwrap_or_else(PoisonError::into_inner) += *part;
    }
}
