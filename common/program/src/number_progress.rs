//! `NumberProgress`: a bar on the terminal that counts the numbers of a scene file that have been
//! moved.

use common::{Color, Progress};
use indicatif::ProgressBar;

use crate::terminal_bar;

/// A bar whose length is known once the numbers are; hidden if stderr is no terminal.
pub struct NumberProgress(ProgressBar);

impl NumberProgress {
    /// A bar with the name of a scene.
    pub fn new(scene: &str) -> Self {
        Self(terminal_bar(scene, 0))
    }
}

impl Progress for NumberProgress {
    fn row(&self, _: u32, _: &mut dyn Iterator<Item = Color>) {
        self.0.inc(1);
    }

    fn more_rows(&self, rows: u32) {
        self.0.inc_length(rows.into());
    }
}

impl Drop for NumberProgress {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
