//! The window on a display of its own: its picture, and the effect of keys and
//! mouse. Where Xvfb or xdotool is missing nothing is tested, and a line says so.

#![cfg(all(target_os = "linux", feature = "window"))]

mod files;
mod keys;
mod lifetime;
mod menu;
mod pictures;
#[path = "../saving/tmpfs.rs"]
mod tmpfs;

use std::path::{Path, PathBuf};
use std::process::Command;

use common::picture_file;
use tempfile::TempDir;
use testing::display::{Picture, RunningProgram};

/// An empty folder to run the program in.
fn folder() -> TempDir {
    tempfile::tempdir().expect("a folder")
}

fn program(folder: &Path, line: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_a01-image-display"));
    command.args(line.split_whitespace()).current_dir(folder);
    command
}

/// The PNG that the book shows.
fn locked_file(scene: &str) -> PathBuf {
    let pictures = concat!(env!("CARGO_MANIFEST_DIR"), "/../book/src/pictures");
    Path::new(pictures).join(file_name(scene))
}

fn file_name(scene: &str) -> String {
    format!("a01-image-display-{scene}.png")
}

fn open(path: &Path) -> Picture {
    Picture::from(&picture_file::open(path).expect("a picture"))
}

fn locked(scene: &str) -> Picture {
    open(&locked_file(scene))
}

/// Waits until the whole picture is in the window, pixel for pixel.
fn wait_for_picture(window: &RunningProgram, scene: &str) {
    let picture = locked(scene);
    window.wait_to_show(scene, |look| look.below_bar() == picture);
}

/// Waits until this is the only text at the bottom of the window.
fn wait_for_notice(window: &RunningProgram, notice: &str) {
    window.wait_to_show(notice, |look| look.notices().join(" ") == notice);
}
