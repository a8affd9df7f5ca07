//! Checks the picture that the program of a stage writes without a display.

use std::path::Path;
use std::process::Command;

use command_line::picture_name;
use common::{Stage, picture_file};

use super::TestPaths;

/// Runs the program without a display and compares the PNG that it writes.
pub fn check_program(stage: &Stage, places: &TestPaths) {
    let folder = tempfile::tempdir().expect("a folder");
    // On these systems the program always finds a display, but can be run without it.
    let always_a_display = cfg!(any(windows, target_os = "macos"));
    let output = Command::new(places.program)
        .args(always_a_display.then_some("--no-window"))
        .current_dir(&folder)
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY")
        .output()
        .expect("the program runs");
    let name = picture_name(stage, &stage.scenes[0]);
    let stdout = String::from_utf8_lossy(&output.stdout);
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{stderr}");
    let explained = always_a_display || stderr.starts_with("no window: ");
    assert!(explained, "{stderr}");
    assert!(stdout.contains(&name), "{stdout}");
    let open = |path: &Path| picture_file::open(path).expect("a picture");
    let left = open(&folder.path().join("out").join(&name));
    let is_same = left == open(&places.expected(&name));
    assert!(is_same, "the program leaves another picture than {name}");
}
