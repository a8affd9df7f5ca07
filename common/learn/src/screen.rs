//! `Screen`: the terminal, which shows one page at a time and a last line that changes; or a pipe,
//! which gets each text once.

use std::cell::Cell;
use std::fmt::Write as _;
use std::io::{self, Write};
use std::path::{Path, absolute};

use common::text;
use console::Term;

use crate::wrap::{wrap, wrap_markdown};

/// The most lines of a program's output that are shown.
const MAX_LINES: usize = 50;

/// On a terminal, the rows that are left to the task and the verdict, and the fewest lines of
/// output, however small the terminal is.
const OTHER_ROWS: usize = 20;
const MIN_LINES: usize = 10;

/// The space for the output of a program.
#[derive(Clone, Copy)]
pub struct Space {
    /// Columns; none in a pipe.
    pub width: Option<usize>,
    /// Lines of the output that are shown.
    pub lines: usize,
}

/// The terminal of the program.
pub struct Screen {
    /// None in a pipe.
    terminal: Option<Term>,
    is_closed: Cell<bool>,
}

impl Screen {
    /// The standard output.
    pub fn new() -> Self {
        let terminal = Term::buffered_stdout();
        Self {
            terminal: terminal.is_term().then_some(terminal),
            is_closed: Cell::new(false),
        }
    }

    /// Whether the reader of a pipe has closed it.
    pub fn is_closed(&self) -> bool {
        self.is_closed.get()
    }

    pub fn is_terminal(&self) -> bool {
        self.terminal.is_some()
    }

    /// Rows and columns; none in a pipe.
    pub fn size(&self) -> Option<(usize, usize)> {
        let (rows, columns) = self.terminal.as_ref()?.size();
        Some((rows.into(), columns.into()))
    }

    /// Columns; none in a pipe.
    pub fn width(&self) -> Option<usize> {
        self.size().map(|(_, columns)| columns)
    }

    /// The space for the output of a program beside the task and the verdict.
    pub fn space(&self) -> Space {
        let size = self.size();
        let lines = size.map_or(MAX_LINES, |(rows, _)| rows.saturating_sub(OTHER_ROWS));
        Space {
            width: self.width(),
            lines: lines.clamp(MIN_LINES, MAX_LINES),
        }
    }

    /// Breaks lines of messages at the width.
    pub fn wrap(&self, text: &str) -> String {
        self.width()
            .map_or_else(|| text.to_owned(), |width| wrap(text, width))
    }

    /// Breaks paragraphs of the book at the width.
    pub fn wrap_markdown(&self, text: &str) -> String {
        self.width()
            .map_or_else(|| text.to_owned(), |width| wrap_markdown(text, width))
    }

    /// Words in which a path leads to its file, on a terminal that has colours; others might show what is a link.
    pub fn link(&self, words: &str, path: &Path) -> String {
        let has_links = |terminal: &Term| terminal.features().colors_supported();
        match absolute(path) {
            Ok(whole) if self.terminal.as_ref().is_some_and(has_links) => {
                let path = text::path(path);
                words.replace(&path, &linked(&path, &whole.to_string_lossy()))
            }
            _ => words.to_owned(),
        }
    }

    /// Shows a page instead of the one before. A pipe gets what is `new` in it.
    pub fn show(&self, page: &str, new: &str) {
        let Some(terminal) = &self.terminal else {
            let is_lost = !new.is_empty() && writeln!(io::stdout(), "{new}").is_err();
            self.is_closed.set(self.is_closed() || is_lost);
            return;
        };
        // If it fails, old text remains.
        let _ = terminal.clear_screen();
        let _ = terminal.write_line(page);
        let _ = terminal.flush();
    }

    /// Replaces the last line. A pipe gets no such lines.
    pub fn show_status(&self, words: &str) {
        if let (Some(terminal), Some(width)) = (&self.terminal, self.width()) {
            let _ = terminal.clear_line();
            let _ = terminal.write_str(&console::truncate_str(words, width - 1, "…"));
            let _ = terminal.flush();
        }
    }
}

/// Words that lead to a file, by the escape sequence OSC 8 of terminals.
fn linked(words: &str, file: &str) -> String {
    let mut address = String::new();
    for byte in file.replace('\\', "/").bytes() {
        if byte.is_ascii_alphanumeric() || b"/-._~:".contains(&byte) {
            address.push(byte.into());
        } else {
            let _ = write!(address, "%{byte:02X}");
        }
    }
    // A path of Windows begins with the letter of a disk.
    let slash = if address.starts_with('/') { "" } else { "/" };
    format!("\u{1b}]8;;file://{slash}{address}\u{1b}\\{words}\u{1b}]8;;\u{1b}\\")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_link_has_the_address_of_a_file() {
        for (file, address) in [
            ("/home/a b/ü%.rs", "file:///home/a%20b/%C3%BC%25.rs"),
            ("C:\\me\\a.rs", "file:///C:/me/a.rs"),
        ] {
            let link = format!("\u{1b}]8;;{address}\u{1b}\\a.rs\u{1b}]8;;\u{1b}\\");
            assert_eq!(linked("a.rs", file), link);
        }
    }
}
