//! The window on a display of its own: its picture, and the effect of keys and
//! mouse. Where Xvfb or xdotool is missing nothing is tested, and a line says so.

#![cfg(all(target_os = "linux", feature = "window"))]

mod display;
mod files;
mod keys;
mod pictures;
mod rendering;

use std::path::{Path, PathBuf};

use crate::display::{Display, picture, wait_for};
use common::{Image, Transfer, picture_file};

/// Runs a test with the program and with its current folder, which is empty.
fn with_window(line: &str, test: impl FnOnce(Display, &Path)) {
    with_window_of(env!("CARGO_BIN_EXE_a01-image-display").as_ref(), line, test);
}

fn with_window_of(program: &Path, line: &str, test: impl FnOnce(Display, &Path)) {
    let folder = tempfile::tempdir().expect("a folder");
    if let Some(window) = Display::start(program, line, folder.path()) {
        test(window, folder.path());
    }
}

/// The PNG that the book shows.
fn locked_file(scene: &str) -> PathBuf {
    let pictures = concat!(env!("CARGO_MANIFEST_DIR"), "/../book/src/pictures");
    Path::new(pictures).join(format!("a01-image-display-{scene}.png"))
}

fn locked(scene: &str) -> Image {
    picture_file::open(&locked_file(scene)).expect("a picture")
}

/// The packed colour of a pixel.
fn packed(image: &Image, x: u32, y: u32) -> u32 {
    Transfer::Linear.pack(image.get(x, y).expect("a pixel"))
}

/// Waits until the window shows this scene, its locked picture pixel for pixel, and no
/// text.
fn wait_for_picture(window: &Display, scene: &str) {
    let locked = locked(scene);
    let title = format!("title: \"a01-image-display: {scene}\"");
    let shown = picture(640, 480, |x, y| packed(&locked, x, y));
    window.wait_for(&[&title, &shown, "texts: []"]);
}

/// Waits until this is the only text at the bottom of the window.
fn wait_for_text(window: &Display, text: &str) {
    window.wait_for(&[&format!("texts: [\"{text}\"]")]);
}

/// Waits until the painter's picture is saved in this folder.
fn wait_for_painter_in(folder: &Path) {
    let path = folder.join("out/a01-image-display-painter.png");
    wait_for("the file", || path.exists().then_some(()));
    assert_eq!(picture_file::open(&path).unwrap(), locked("painter"));
}

fn close(window: Display) {
    window.press("Escape");
    window.wait_for_end();
}
