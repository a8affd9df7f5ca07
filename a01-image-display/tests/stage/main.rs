//! Tests of the program of this stage: exit codes, messages, and the files that it leaves.
//!
//! `cargo test` runs them after `pictures`, whose failures leave pictures to look at.

mod output;
mod refusals;

use std::fs;
use std::path::Path;
use std::process::Command;

use tempfile::TempDir;

/// An empty folder to run the program in.
fn folder() -> TempDir {
    tempfile::tempdir().expect("a folder")
}

/// Whether the program finds a display without an environment variable.
const ALWAYS_A_DISPLAY: bool = cfg!(any(windows, target_os = "macos"));

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

/// Exit code, stdout and stderr of a program.
fn run(mut program: Command) -> (Option<i32>, String, String) {
    let output = program.output().expect("the program runs");
    let text = |bytes| String::from_utf8(bytes).expect("text");
    (
        output.status.code(),
        text(output.stdout),
        text(output.stderr),
    )
}

/// The names of all files and folders below, these with a slash at their end.
fn files(folder: &Path) -> Vec<String> {
    let mut names = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().unwrap().to_str().unwrap();
        if path.is_dir() {
            let below = files(&path).into_iter().chain([String::new()]);
            names.extend(below.map(|below| format!("{name}/{below}")));
        } else {
            names.push(name.to_owned());
        }
    }
    names.sort();
    names
}

fn test_card() -> Vec<u8> {
    fs::read(concat!(env!("CARGO_MANIFEST_DIR"), "/assets/test-card.png")).unwrap()
}
