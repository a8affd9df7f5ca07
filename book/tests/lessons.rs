//! The files of the lessons hold the lesson and nothing else, and are short.

use std::sync::LazyLock;

use book::{Files, ending};

/// The most lines of all lessons, and of one lesson file.
const OF_ALL: usize = 3_600;
const OF_A_LESSON: usize = 200;
/// The most lines of the loop over the pixels.
const OF_RENDER: usize = 80;

/// Words that belong to the folders beside the lessons, or to speed.
const FOREIGN: &str = "engine lab laboratory packet packets lane lanes simd tally counting
    omit omits omitted omission omissions renderer prepared black_box max_error";

static FILES: LazyLock<Files> = LazyLock::new(|| Files::read().expect("the repository"));

/// Paths and texts of all Rust files.
fn rust_files() -> impl Iterator<Item = (&'static str, &'static str)> {
    FILES.below("").filter(|(path, _)| ending(path) == "rs")
}

/// The files that join a stage with its program, its lab, the engine and the window.
const JOINTS: &str = "lib.rs main.rs stage.rs view.rs fast.rs lab.rs window.rs canvas.rs";

/// The lesson files of all stages: `src/*.rs` without the joints.
fn lessons() -> Vec<(&'static str, &'static str)> {
    let is_lesson = |path: &str| {
        path.split_once("/src/").is_some_and(|(stage, name)| {
            let is_joint = JOINTS.split(' ').any(|joint| joint == name);
            stage.starts_with("a0") && !name.contains('/') && !is_joint
        })
    };
    let files: Vec<_> = rust_files().filter(|(path, _)| is_lesson(path)).collect();
    assert!(files.len() > 40, "only {} lesson files", files.len());
    files
}

#[test]
fn lessons_name_nothing_but_the_lesson() {
    let foreign: Vec<_> = FOREIGN.split_whitespace().collect();
    let mut found = Vec::new();
    for (path, text) in lessons() {
        for (number, line) in (1..).zip(text.lines()) {
            let words = line.split(|c: char| !(c.is_alphanumeric() || c == '_'));
            for word in words.filter(|word| foreign.contains(&&*word.to_lowercase())) {
                found.push(format!("{path}:{number}: {word}"));
            }
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn lessons_are_short() {
    let (mut all, mut long) = (0, Vec::new());
    for (path, text) in lessons() {
        let lines = text.lines().count();
        all += lines;
        let is_render = path.ends_with("/render.rs");
        if lines > if is_render { OF_RENDER } else { OF_A_LESSON } {
            long.push((path, lines));
        }
    }
    assert!(long.is_empty(), "too long: {long:?}");
    assert!(all <= OF_ALL, "{all} lines in all, at most {OF_ALL}");
}
