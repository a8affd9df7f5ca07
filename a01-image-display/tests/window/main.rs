//! The window on a display of its own: the effect of keys and mouse, by its state and by the
//! hash of the picture's bytes. Where Xvfb or xdotool is missing nothing is tested, and a line
//! says so.

#![cfg(all(target_os = "linux", feature = "window"))]

mod display;
mod rendering;

use std::fs;
use std::path::{Path, PathBuf};

use common::{Transfer, fnv1a, picture_file};

use crate::display::{Display, wait_for};

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
fn locked(scene: &str) -> PathBuf {
    let pictures = concat!(env!("CARGO_MANIFEST_DIR"), "/../book/src/pictures");
    Path::new(pictures).join(format!("a01-image-display-{scene}.png"))
}

/// Waits until the window shows the finished picture of a scene, byte for byte.
fn wait_for_picture(window: &Display, scene: &str) {
    let picture = picture_file::open(&locked(scene)).expect("a picture");
    let hash = fnv1a(&picture.to_rgb8(Transfer::Linear));
    window.wait_for(&[&format!(": {scene}\""), &format!("picture: Some({hash})")]);
}

fn wait_for_painter_in(folder: &Path) {
    let path = folder.join("out/a01-image-display-painter.png");
    wait_for("the file", || path.exists().then_some(()));
    assert_eq!(
        picture_file::open(&path).unwrap(),
        picture_file::open(&locked("painter")).unwrap()
    );
}

/// Pairs of a key and its effect, with commas between them.
fn in_steps(text: &str) -> impl Iterator<Item = (&str, &str)> {
    text.split(", ")
        .map(|step| step.split_once(' ').expect("a key and its effect"))
}

#[test]
fn keys_save_close_and_go_round_the_scenes() {
    with_window("", |window, folder| {
        // Without Ctrl, W has no effect.
        window.press("w");
        let steps =
            "Right painter, Right show-image, Right diagonal, Left show-image, Left painter";
        for (key, scene) in in_steps(steps) {
            window.press(key);
            wait_for_picture(&window, scene);
        }
        assert_eq!(folder.read_dir().unwrap().count(), 0, "no file");
        for key in ["s", "ctrl+s"] {
            window.press(key);
            wait_for_painter_in(folder);
            window.wait_for(&["saved out/a01-image-display-painter.png"]);
            fs::remove_dir_all(folder.join("out")).unwrap();
        }
        // Releases of keys are not reported while the window has no keyboard.
        window.act("keydown ctrl windowunmap --sync WINDOW");
        window.wait_for(&["is_active: false"]);
        window.act("keyup ctrl windowmap --sync WINDOW");
        window.focus();
        window.press("w h");
        window.wait_for(&["page: Some(Menu)"]);
        window.press("ctrl+w");
        window.wait_for_end();
    });
}

#[test]
fn the_menu_works_by_keyboard_and_by_mouse() {
    with_window("show painter", |window, folder| {
        wait_for_picture(&window, "painter");
        let keys =
            "F10 Some(Save), Down Some(Close), Up Some(Save), Up Some(Scene(2)), Down Some(Save)";
        for (key, selected) in in_steps(keys) {
            window.press(key);
            window.wait_for(&[&format!("selected: {selected}")]);
        }
        window.press("Return");
        wait_for_painter_in(folder);
        window.click("diagonal", 0.5);
        wait_for_picture(&window, "diagonal");
        window.click("Dark or light", 0.5);
        window.wait_for(&["Light scale: 1 "]);
        window.press("ctrl+plus");
        window.wait_for(&["scale: 1.125 "]);
        for side in [(200, 100), (1, 1), (1, 600), (800, 1)] {
            window.act(&format!("windowsize WINDOW {} {}", side.0, side.1));
            window.wait_for(&[&format!("window: {side:?}")]);
        }
        window.press("Escape Escape");
        window.wait_for_end();
    });
}

#[test]
fn wheel_keys_and_drags_zoom_and_move_the_picture() {
    with_window("show painter --ui-scale 100", |window, _| {
        wait_for_picture(&window, "painter");
        window.point_at(320, 240);
        window.wait_for(&["column 320, row 240: (255, 0, 0)"]);
        for (act, zoom) in [
            ("click 4", "Factor(2, "),
            ("key plus", "Factor(3, "),
            ("key minus", "Factor(2, "),
            ("click 5", "zoom: Fit"),
            ("click 4", "Factor(2, (320.25, 240.25))"),
        ] {
            window.act(act);
            window.wait_for(&[zoom]);
        }
        window.hold(1, || window.point_at(300, 250));
        window.wait_for(&["Factor(2, (330.25, 235.25))", "pixel: None"]);
        // The first click explains a pixel; the second one fits the picture, if it comes soon.
        wait_for("a double click", || {
            window.act(
                "mousedown 1 sleep 0.03 mouseup 1 sleep 0.03 mousedown 1 sleep 0.03 mouseup 1",
            );
            window.wait_for(&["left: false"]);
            window.state().contains("zoom: Fit").then_some(())
        });
        window.press("Escape");
        window.wait_for(&["pixel: None"]);
    });
}

#[test]
fn the_window_fits_the_screen_and_the_picture_the_window() {
    for (size, window_size, scale) in [
        ("640x480", (640, 510), "1.0"),
        ("3000x2000", (1080, 750), "0.36"),
        ("1x1", (320, 190), "160.0"),
    ] {
        with_window(&format!("show painter --size {size}"), |window, _| {
            window.wait_for(&[
                &format!("window: {window_size:?}"),
                &format!("scale: {scale},"),
            ]);
        });
    }
}

#[test]
fn errors_are_shown_and_nothing_is_lost() {
    with_window("show diagonal --open half.png", |window, folder| {
        let card = fs::read(locked("show-image")).unwrap();
        fs::write(folder.join("half.png"), &card[..card.len() / 2]).unwrap();
        window.press("Left");
        window.wait_for(&["cannot open half.png: the file ends too early"]);
        window.press("s");
        window.wait_for(&["there is no picture to save"]);
        window.press("Left");
        wait_for_picture(&window, "painter");
        let out = folder.join("out");
        fs::write(&out, "a letter").unwrap();
        window.press("s");
        window.wait_for(&["out is a file, not a folder"]);
        assert_eq!(fs::read_to_string(&out).unwrap(), "a letter");
    });
    with_window("show show-image", |window, _| {
        window.wait_for(&["no file was chosen; the argument --open FILE shows one, too"]);
        wait_for_picture(&window, "show-image");
    });
}
