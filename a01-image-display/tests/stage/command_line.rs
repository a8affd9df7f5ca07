//! The real program: exit codes, messages, and the files that it leaves.

mod no_window;
mod refusals;
mod rendering;

use std::fs;
use std::path::Path;
use std::process::Command;

use common::{Image, picture_file};
use tempfile::TempDir;

const PICTURES: [&str; 3] = [
    "a01-image-display-diagonal.png",
    "a01-image-display-painter.png",
    "a01-image-display-show-image.png",
];

/// An empty folder to run the program in.
fn folder() -> TempDir {
    tempfile::tempdir().expect("a folder")
}

fn program(folder: &TempDir, line: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_a01-image-display"));
    command
        .args(line.split_whitespace())
        .current_dir(folder)
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY");
    let opens_no_window = ["list", "render", "--help"].map(|start| line.starts_with(start));
    if ALWAYS_A_DISPLAY && !opens_no_window.contains(&true) {
        command.arg("--no-window");
    }
    command
}

/// Whether the program finds a display without an environment variable.
const ALWAYS_A_DISPLAY: bool = cfg!(any(windows, target_os = "macos"));

/// Exit code, stdout and stderr of the program with these arguments.
fn run(folder: &TempDir, line: &str) -> (i32, String, String) {
    let output = program(folder, line).output().expect("the program runs");
    let text = |bytes| String::from_utf8(bytes).expect("text");
    let (said, complaint) = (text(output.stdout), text(output.stderr));
    let code = output.status.code().expect("an exit code");
    (code, said, complaint)
}

/// The names of all files and folders below, sorted.
fn left(folder: &TempDir) -> Vec<String> {
    fn walk(root: &Path, folder: &Path, names: &mut Vec<String>) {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.strip_prefix(root).unwrap();
            names.push(name.to_str().unwrap().replace('\\', "/"));
            if path.is_dir() {
                walk(root, &path, names);
            }
        }
    }
    let mut names = Vec::new();
    walk(folder.path(), folder.path(), &mut names);
    names.sort();
    names
}

fn open(folder: &TempDir, name: &str) -> Image {
    picture_file::open(&folder.path().join(name)).expect("a whole picture")
}

fn test_card() -> Vec<u8> {
    fs::read(concat!(env!("CARGO_MANIFEST_DIR"), "/assets/test-card.png")).unwrap()
}

/// The program must end with this code and one sentence that holds `sentence`,
/// say nothing else, and leave the files as they were.
fn assert_refused(folder: &TempDir, line: &str, code: i32, sentence: &str) {
    let before = left(folder);
    let (ended, said, complaint) = run(folder, line);
    assert!(complaint.contains(sentence), "{line}: {complaint}");
    assert_eq!(complaint.matches("error: ").count(), 1, "{complaint}");
    assert_eq!(ended, code, "{line}: {complaint}");
    assert_eq!(said, "", "{line}");
    assert_eq!(left(folder), before, "{line}");
}
