//! The window on a display of its own: the effect of keys and mouse, by its state and by the
//! hash of the picture's bytes. Where Xvfb or xdotool is missing nothing is tested, and a line
//! says so.

#![cfg(all(target_os = "linux", feature = "window"))]

mod display;
mod rendering;

use std::fs;
use std::path::{Path, PathBuf};

use common::{Transfer, fnv1a, picture_file};

use crate::display::{Display, FOCUS, wait_for};

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

/// The state of a window that shows the finished picture of a scene, byte for byte.
fn shown(scene: &str) -> String {
    let picture = picture_file::open(&locked(scene)).expect("a picture");
    let hash = fnv1a(&picture.to_rgb8(Transfer::Linear));
    format!(": {scene}\" & picture: Some({hash})")
}

fn wait_for_painter_in(folder: &Path) {
    let path = folder.join("out/a01-image-display-painter.png");
    wait_for("the file", || path.exists().then_some(()));
    let [saved, locked] = [path, locked("painter")].map(|path| picture_file::open(&path).unwrap());
    assert_eq!(saved, locked);
}

#[test]
fn keys_save_close_and_go_round_the_scenes() {
    with_window("", |window, folder| {
        let [diagonal, painter, image] = ["diagonal", "painter", "show-image"].map(shown);
        window.play(&[
            // Without Ctrl, W has no effect.
            ("key w", &diagonal),
            ("key Right", &painter),
            ("key Right", &image),
            ("key Right", &diagonal),
            ("key Left", &image),
            ("key Left", &painter),
        ]);
        assert_eq!(folder.read_dir().unwrap().count(), 0, "no file");
        for key in ["key s", "key ctrl+s"] {
            window.play(&[(key, "saved out/a01-image-display-painter.png")]);
            wait_for_painter_in(folder);
            fs::remove_dir_all(folder.join("out")).unwrap();
        }
        window.play(&[
            // Releases of keys are not reported while the window has no keyboard.
            ("keydown ctrl windowunmap --sync WINDOW", "is_active: false"),
            ("keyup ctrl windowmap --sync WINDOW", ""),
            FOCUS,
            ("key w h", "page: Some(Menu)"),
            ("key ctrl+w", ""),
        ]);
        window.wait_for_end();
    });
}

#[test]
fn the_menu_works_by_keyboard_and_by_mouse() {
    with_window("show painter", |window, folder| {
        window.play(&[
            ("key F10", &selected("Save as PNG")),
            ("key Down", &selected("Close")),
            ("key Up", &selected("Save as PNG")),
            ("key Up", &selected("show-image")),
            (
                "key Down",
                &format!("{} & {}", shown("painter"), selected("Save as PNG")),
            ),
            ("key Return", "saved"),
        ]);
        wait_for_painter_in(folder);
        window.play(&[
            ("item 0.5 diagonal", &shown("diagonal")),
            ("item 0.5 Dark or light", "Light scale: 1 "),
            ("key ctrl+plus", "scale: 1.125 "),
        ]);
        for side in [(200, 100), (1, 1), (1, 600), (800, 1), (800, 600)] {
            let resize = format!("windowsize WINDOW {} {}", side.0, side.1);
            window.play(&[(&resize, &format!("window: {side:?}"))]);
        }
        window.play(&[
            ("key F10 F10", &selected("Save as PNG")),
            ("key Down Return", ""),
        ]);
        window.wait_for_end();
    });
}

/// The state of a window with a selected entry.
fn selected(text: &str) -> String {
    format!("is_selected: true, text: {text:?}")
}

#[test]
fn wheel_keys_and_drags_zoom_and_move_the_picture() {
    with_window("show painter --ui-scale 100", |window, _| {
        window.play(&[
            (
                "mousemove --window WINDOW 320 240",
                "column 320, row 240: (255, 0, 0)",
            ),
            ("click 4", "Factor(2.0, "),
            ("key plus", "Factor(3.0, "),
            ("key minus", "Factor(2.0, "),
            ("click 5", "zoom: Fit"),
            ("click 4", "Factor(2.0, [320.25, 240.25])"),
            ("mousedown 1", "left: true"),
            (
                "mousemove --window WINDOW 300 250",
                "Factor(2.0, [330.25, 235.25])",
            ),
            ("mouseup 1", "left: false & pixel: None"),
        ]);
        // The first click explains a pixel; the second one fits the picture, if it comes soon.
        let click = "mousedown 1 sleep 0.03 mouseup 1 sleep 0.03";
        wait_for("a double click", || {
            window.play(&[(&format!("{click} {click}"), "left: false")]);
            window.state().contains("zoom: Fit").then_some(())
        });
        window.play(&[("key Escape", "pixel: None"), ("key Escape", "")]);
        window.wait_for_end();
    });
}

#[test]
fn the_window_fits_the_screen_and_the_picture_the_window() {
    for (size, state) in [
        ("640x480", "window: (640, 510) & scale: 1.0,"),
        ("3000x2000", "window: (1080, 750) & scale: 0.36,"),
        ("1x1", "window: (320, 190) & scale: 160.0,"),
    ] {
        with_window(&format!("show painter --size {size}"), |window, _| {
            window.play(&[("key w", state)]);
        });
    }
}

#[test]
fn errors_are_shown_and_nothing_is_lost() {
    with_window("show diagonal --open half.png", |window, folder| {
        let card = fs::read(locked("show-image")).unwrap();
        fs::write(folder.join("half.png"), &card[..card.len() / 2]).unwrap();
        let out = folder.join("out");
        fs::write(&out, "a letter").unwrap();
        window.play(&[
            ("key Left", "cannot open half.png: the file ends too early"),
            ("key s", "there is no picture to save"),
            ("key Left", &shown("painter")),
            ("key s", "out is a file, not a folder"),
        ]);
        assert_eq!(fs::read_to_string(&out).unwrap(), "a letter");
    });
    with_window("show show-image", |window, _| {
        let message = "no file was chosen; the argument --open FILE shows one, too";
        window.play(&[("key w", &format!("{message} & {}", shown("show-image")))]);
    });
}
