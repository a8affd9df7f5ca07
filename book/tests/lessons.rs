//! The files of the lessons hold the lesson and nothing else.

use crate::files::Files;

/// Words that belong to the folders beside the lessons, or to speed.
const FOREIGN: &str = "engine lab laboratory packet packets lane lanes simd tally counting
    omit omits omitted omission omissions renderer prepared black_box max_error";

/// The files that join a stage with its program, the engine and the window.
const JOINTS: &str = "lib.rs main.rs stage.rs view.rs kinds.rs instruments.rs window.rs canvas.rs";

/// Whether a file is a lesson of any stage: `src/*.rs` without the joints.
pub fn is_lesson(path: &str) -> bool {
    path.split_once("/src/").is_some_and(|(stage, name)| {
        let is_joint = JOINTS.split(' ').any(|joint| joint == name);
        stage.starts_with("a0") && ![stage, name].concat().contains('/') && !is_joint
    })
}

/// The foreign words in lessons.
pub fn complaints(files: &Files) -> Vec<String> {
    let foreign: Vec<_> = FOREIGN.split_whitespace().collect();
    let lessons: Vec<_> = files.rust().filter(|(path, _)| is_lesson(path)).collect();
    assert!(lessons.len() > 40, "only {} lesson files", lessons.len());
    let mut found = Vec::new();
    for (path, text) in lessons {
        for (number, line) in (1..).zip(text.lines()) {
            let words = line.split(|c: char| !(c.is_alphanumeric() || c == '_'));
            for word in words.filter(|word| foreign.contains(&&*word.to_lowercase())) {
                found.push(format!("{path}:{number}: {word}"));
            }
        }
    }
    found
}
