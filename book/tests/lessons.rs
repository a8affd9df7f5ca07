//! The files of the lessons hold the lesson and nothing else, and are short.

use std::fs;
use std::path::{Path, PathBuf};

/// The most lines of all lessons, of one lesson file, and of any Rust file.
const OF_ALL: usize = 3_600;
const OF_A_LESSON: usize = 200;
const OF_A_FILE: usize = 300;
/// The most lines of the loop over the pixels.
const OF_RENDER: usize = 80;

/// Words that belong to the folders beside the lessons, or to speed.
const FOREIGN: &str =
    "engine lab laboratory packet packets lane lanes simd tally counting plan plans
    planned omit omits omitted omission omissions renderer prepared black_box max_error";

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The Rust files in a folder; also in those below it if `deep`.
fn rust_files(folder: &Path, deep: bool) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if path.is_dir() && deep && name != "target" && !name.starts_with('.') {
            files.extend(rust_files(&path, true));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files
}

fn text(path: &Path) -> String {
    fs::read_to_string(path).expect("a text")
}

/// The files that join a stage with its program, its lab, the engine and the window.
const JOINTS: &str = "lib.rs main.rs stage.rs fast.rs lab.rs window.rs canvas.rs";

/// The lesson files of all stages: `src/*.rs` without the joints.
fn lessons() -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(root()).expect("the workspace") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if name.starts_with("a0") {
            files.extend(rust_files(&path.join("src"), false));
        }
    }
    files.retain(|path| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        !JOINTS.split(' ').any(|joint| joint == name)
    });
    assert!(files.len() > 40, "only {} lesson files", files.len());
    files
}

#[test]
fn lessons_name_nothing_but_the_lesson() {
    let foreign: Vec<_> = FOREIGN.split_whitespace().collect();
    let mut found = Vec::new();
    for path in lessons() {
        for (number, line) in (1..).zip(text(&path).lines()) {
            let words = line.split(|c: char| !(c.is_alphanumeric() || c == '_'));
            for word in words.filter(|word| foreign.contains(&&*word.to_lowercase())) {
                found.push(format!("{}:{number}: {word}", path.display()));
            }
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn lessons_are_short() {
    let mut all = 0;
    let mut long = Vec::new();
    for path in lessons() {
        let lines = text(&path).lines().count();
        all += lines;
        let most = if path.ends_with("render.rs") {
            OF_RENDER
        } else {
            OF_A_LESSON
        };
        if lines > most {
            long.push(format!("{}: {lines} lines, at most {most}", path.display()));
        }
    }
    assert!(long.is_empty(), "{}", long.join("\n"));
    assert!(all <= OF_ALL, "{all} lines in all, at most {OF_ALL}");
}

#[test]
fn no_file_is_long() {
    let mut long = Vec::new();
    for path in rust_files(&root(), true) {
        let lines = text(&path).lines().count();
        if lines > OF_A_FILE {
            long.push(format!("{}: {lines} lines", path.display()));
        }
    }
    assert!(long.is_empty(), "{}", long.join("\n"));
}
