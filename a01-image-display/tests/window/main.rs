//! The window on a display of its own: its picture, and the effect of keys and
//! mouse. Where Xvfb or xdotool is missing nothing is tested, and a line says so.

#![cfg(all(target_os = "linux", feature = "window"))]

mod files;
mod keys;
mod lifetime;
mod menu;
mod pictures;

use std::path::{Path, PathBuf};

use common::picture_file;
use testing::display::{Picture, Shown, wait_for};

/// Runs a test with the program on a screen of 800x600 pixels, and with its current
/// folder, which is empty.
fn with_window(line: &str, test: impl FnOnce(Shown, &Path)) {
    let folder = tempfile::tempdir().expect("a folder");
    with_window_in(folder.path(), line, [800, 600], |window| {
        test(window, folder.path());
    });
}

fn with_window_in(folder: &Path, line: &str, screen: [u32; 2], test: impl FnOnce(Shown)) {
    let program = env!("CARGO_BIN_EXE_a01-image-display");
    if let Some(window) = Shown::start(program, line, folder, screen) {
        test(window);
    }
}

/// The PNG that the book shows.
fn locked_file(scene: &str) -> PathBuf {
    let pictures = concat!(env!("CARGO_MANIFEST_DIR"), "/../book/src/pictures");
    Path::new(pictures).join(format!("a01-image-display-{scene}.png"))
}

fn open(path: &Path) -> Picture {
    Picture::from(&picture_file::open(path).expect("a picture"))
}

fn locked(scene: &str) -> Picture {
    open(&locked_file(scene))
}

/// Waits until the whole picture is in the window, pixel for pixel.
fn wait_for_picture(window: &Shown, scene: &str) {
    let picture = locked(scene);
    window.wait_to_show(scene, |look| look.below_bar() == picture);
}

/// Waits until this is the only text at the bottom of the window.
fn wait_for_notice(window: &Shown, notice: &str) {
    window.wait_to_show(notice, |look| look.notices().join(" ") == notice);
}

/// Waits until the painter's picture is saved in this folder.
fn wait_for_painter_in(folder: &Path) {
    let path = folder.join("out/a01-image-display-painter.png");
    wait_for("the file", || path.exists().then_some(()));
    assert_eq!(open(&path), locked("painter"));
}

fn close(window: Shown) {
    window.press("Escape");
    assert_eq!(window.wait_for_end(), (Some(0), String::new()));
}
