//! `Report`: what a check says about a student's file.

use crate::exercise::Exercise;
use crate::screen::Screen;

/// What a check says about a student's file.
#[derive(Default)]
pub struct Report {
    pub is_done: bool,
    /// The output of the student's program, or of the compiler.
    pub printed: String,
    /// What is wrong.
    pub words: String,
    /// The verdict in a line, such as `sphere: done`.
    pub verdict: String,
}

impl Report {
    pub fn new(e: &Exercise, verdict: &str) -> Self {
        Self {
            verdict: format!("{}: {verdict}", e.name),
            ..Self::default()
        }
    }

    /// What a student reads above the verdict.
    pub fn details(&self, screen: &Screen) -> String {
        let mut text = String::new();
        for lines in [&self.printed, &screen.wrap(&self.words)] {
            if !lines.is_empty() {
                text.extend([lines.trim_end(), "\n"]);
            }
        }
        text
    }
}
