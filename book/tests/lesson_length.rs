//! A lesson is read in one sitting, so its files stay short.

use crate::files::Files;
use crate::lessons::is_lesson;

/// The most lines of a lesson's file.
const OF_A_LESSON: usize = 200;

/// The most lines of the loop over the pixels, which every chapter shows.
const OF_RENDER: usize = 80;

/// The lesson files that are too long.
pub fn complaints(files: &Files) -> Vec<String> {
    let mut found = Vec::new();
    for (path, text) in files.rust() {
        if !is_lesson(path) {
            continue;
        }
        let most = match path {
            "a03-rays-cameras/src/render.rs" => OF_RENDER,
            _ => OF_A_LESSON,
        };
        let lines = text.lines().count();
        if lines > most {
            found.push(format!("{path}: {lines} lines, at most {most}"));
        }
    }
    found
}
