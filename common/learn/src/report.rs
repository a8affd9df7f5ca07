//! `Report`: what a check says about a student's file.

use std::path::Path;
use std::{fs, io};

use common::text;

use crate::exercise::Exercise;
use crate::files;
use crate::output::Output;
use crate::screen::Screen;

/// What a check says about a student's file.
#[derive(Default)]
pub struct Report {
    pub is_done: bool,
    /// Whether the student has stopped the check.
    pub is_stopped: bool,
    /// The output of the student's program, or of the compiler.
    pub printed: String,
    /// What is wrong.
    pub words: String,
    /// What is true besides, for those who want to know more.
    pub remarks: String,
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

    /// What a student reads above the verdict: of a file that is right, no remarks, unless they are
    /// asked for.
    pub fn details(&self, screen: &Screen, has_remarks: bool) -> String {
        let mut text = String::new();
        add_lines(&mut text, &self.printed);
        add_lines(&mut text, &screen.wrap(&self.words));
        if has_remarks || !self.is_done {
            add_lines(&mut text, &screen.wrap(&self.remarks));
        }
        text
    }

    /// Whether details without remarks leave something out.
    pub fn hides_something(&self) -> bool {
        self.is_done && !self.remarks.is_empty()
    }
}

fn add_lines(text: &mut String, lines: &str) {
    if !lines.is_empty() {
        *text += lines.trim_end();
        *text += "\n";
    }
}

/// Says how many lines of an output are not shown, and writes them to a file.
pub fn say_cut(e: &Exercise, output: &Output, more: usize) -> String {
    if more == 0 {
        return String::new();
    }
    let cut = format!("\n… {more} more lines");
    let path = files::shortest(&format!("out/exercises/{}.txt", e.name));
    if write_into_folder(&path, &output.kept).is_err() {
        // Without the file, the number of lines is still true.
        return cut;
    }
    let part = if output.is_cut {
        "the first MiB"
    } else {
        "all"
    };
    format!("{cut}; {} has {part} of them", text::path(&path))
}

fn write_into_folder(path: &Path, bytes: &[u8]) -> io::Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    fs::write(path, bytes)
}
