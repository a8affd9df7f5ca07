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
