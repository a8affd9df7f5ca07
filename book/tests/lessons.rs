//! The files in `src/` of a stage hold the lesson and nothing else: what joins it with its program, the
//! engine and scene files is in the folder `src/program/`.

use crate::files::Files;

/// Crates and folders that a lesson does not name.
const FOREIGN: [&str; 6] = [
    "program",
    "engine",
    "scene_file",
    "measure",
    "kinds",
    "instruments",
];

/// Whether a file is a lesson of any stage, or its scenes: `src/*.rs` without the roots of its crates.
fn is_lesson(path: &str) -> bool {
    path.split_once("/src/").is_some_and(|(stage, name)| {
        let is_root = ["lib.rs", "main.rs"].contains(&name);
        stage.starts_with("a0") && ![stage, name].concat().contains('/') && !is_root
    })
}

/// The foreign words in the code of lessons.
pub fn complaints(files: &Files) -> Vec<String> {
    let lessons: Vec<_> = files.rust().filter(|(path, _)| is_lesson(path)).collect();
    assert!(lessons.len() > 40, "only {} lesson files", lessons.len());
    let mut found = Vec::new();
    for (path, text) in lessons {
        for (number, line) in (1..).zip(text.lines()) {
            // A comment may tell of them.
            let code = line.split("//").next().unwrap_or_default();
            let words = code.split(|c: char| !(c.is_alphanumeric() || c == '_'));
            for word in words.filter(|word| FOREIGN.contains(word)) {
                found.push(format!("{path}:{number}: {word}"));
            }
        }
    }
    found
}
