//! `Status`: a line that shows what a command without keys is doing.

use std::time::Duration;

use console::{Term, truncate_str};

use crate::phase::Phase;

/// A line of the standard error, which is there while the command works.
pub struct Status {
    terminal: Term,
    shown: String,
}

impl Status {
    pub fn new() -> Self {
        Self {
            terminal: Term::stderr(),
            shown: String::new(),
        }
    }

    /// Shows what goes on. A log gets only the first line, and only of what takes long.
    pub fn show(&mut self, what: &str, phase: Phase, elapsed: Duration) {
        let words = phase.words(what, elapsed);
        if !self.terminal.is_term() {
            if self.shown.is_empty() && elapsed.as_secs() > 0 {
                self.shown = words;
                eprintln!("{}", self.shown);
            }
        } else if self.shown != words {
            let columns = usize::from(self.terminal.size().1);
            // If it fails, the line is not seen, and nothing else depends on it.
            let _ = self.terminal.clear_line();
            let _ = self
                .terminal
                .write_str(&truncate_str(&words, columns - 1, "…"));
            self.shown = words;
        }
    }
}

impl Drop for Status {
    fn drop(&mut self) {
        if self.terminal.is_term() {
            let _ = self.terminal.clear_line();
        }
    }
}
