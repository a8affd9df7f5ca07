//! The window on a display of its own: the effect of keys and mouse, by its state and by the
//! hash of the picture's bytes. Where Xvfb, xdotool or a library of windows is missing
//! nothing is tested, and a line says so.

#![cfg(all(target_os = "linux", feature = "window"))]

use std::path::{Path, PathBuf};
use std::time::Duration;
use std::{fs, thread};

use common::picture_file;
use testing::display::{self, Display, FOCUS, wait_for};

/// The program with its window; none where it cannot be tested.
fn start(line: &str) -> Option<Display> {
    Display::start(env!("CARGO_BIN_EXE_a01-image-display"), line)
}

/// The PNG that the book shows.
fn locked(scene: &str) -> PathBuf {
    let pictures = concat!(env!("CARGO_MANIFEST_DIR"), "/../book/src/pictures");
    Path::new(pictures).join(format!("a01-image-display-{scene}.png"))
}

/// The state of a window that shows the finished picture of a scene.
fn shown(scene: &str) -> String {
    let picture = picture_file::open(&locked(scene)).expect("a picture");
    format!(": {scene}\" & {}", display::shown(&picture))
}

fn wait_for_painter_in(folder: &Path) {
    let path = folder.join("out/a01-image-display-painter.png");
    wait_for("the file", || path.exists().then_some(()));
    let [saved, locked] = [path, locked("painter")].map(|path| picture_file::open(&path).unwrap());
    assert_eq!(saved, locked);
}

#[test]
fn keys_save_close_and_go_round_the_scenes() {
    let Some(window) = start("") else { return };
    let folder = window.folder.path();
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
}

#[test]
fn the_menu_works_by_keyboard_and_by_mouse() {
    let Some(window) = start("show painter") else {
        return;
    };
    let selected = |text: &str| format!("selected: {text:?}");
    let painter_is_shown = format!("{} & {}", shown("painter"), selected("Save as PNG"));
    window.play(&[
        ("key F10", &selected("Save as PNG")),
        ("key Down", &selected("Open …")),
        ("key Tab", &selected("Open by its path")),
        ("key shift+Tab Up", &selected("Save as PNG")),
        ("key Up", &selected("show-image")),
        ("key Down", &painter_is_shown),
        ("key Return", "saved"),
    ]);
    wait_for_painter_in(window.folder.path());
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
        ("key Down Down Down Return", ""),
    ]);
    window.wait_for_end();
}

#[test]
fn wheel_keys_and_drags_zoom_and_move_the_picture() {
    let Some(window) = start("show painter --ui-scale 100") else {
        return;
    };
    let pixel = "column 320, row 240: (255, 0, 0)";
    window.play(&[
        ("mousemove --window WINDOW 320 240", pixel),
        // A notch of xdotool counts twice: when it begins and when it ends.
        ("click 4", "scale: 3.0,"),
        ("key plus", &format!("scale: 4.0, & {pixel}")),
        ("key minus", "scale: 3.0,"),
        ("click 5", "scale: 1.0, & is_zoomed: false"),
        // The middle of the pixel under the mouse stays, but for half a pixel of the window.
        ("click 4", "scale: 3.0, corner: [-642.0, -482.0]"),
        ("mousedown 1", "left: true"),
        (
            "mousemove --window WINDOW 300 250",
            "corner: [-662.0, -472.0]",
        ),
        ("mouseup 1", "left: false & pixel: None"),
    ]);
    // The first click explains a pixel; the second one fits the picture, if it comes soon.
    wait_for("a double click", || {
        window.play(&[("click --repeat 2 --delay 30 1", "left: false")]);
        window.state().contains("is_zoomed: false").then_some(())
    });
    window.play(&[("key Escape", "pixel: None"), ("key Escape", "")]);
    window.wait_for_end();
}

#[test]
fn the_window_fits_the_screen_and_the_picture_the_window() {
    for (size, state) in [
        ("640x480", "window: (640, 510) & scale: 1.0,"),
        ("3000x2000", "window: (1080, 750) & scale: 0.36,"),
        ("1x1", "window: (320, 190) & scale: 160.0,"),
    ] {
        if let Some(window) = start(&format!("show painter --size {size}")) {
            window.play(&[("key w", state)]);
        }
    }
}

#[test]
fn errors_are_shown_and_nothing_is_lost() {
    let Some(window) = start("show diagonal --open half.png") else {
        return;
    };
    let card = fs::read(locked("show-image")).unwrap();
    let folder = window.folder.path();
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
}

#[test]
fn a_picture_is_shown_where_no_file_is_chosen() {
    let Some(window) = start("show show-image") else {
        return;
    };
    let message = "no file was chosen; P opens one by its path";
    window.play(&[("key w", &format!("{message} & {}", shown("show-image")))]);
}

#[test]
fn no_click_is_lost() {
    let Some(window) = start("show painter") else {
        return;
    };
    for x in (100..200).step_by(10) {
        let there = format!("mousemove --window WINDOW {x} 50");
        let at = format!("at: [{x}, 50]");
        // Button down and up follow each other as fast as the server takes them.
        let pixel = format!("pixel: Some([{x}, 50])");
        window.play(&[
            (&there, &at),
            ("click 1", &pixel),
            ("key Escape", "pixel: None"),
        ]);
    }
}

#[test]
fn an_idle_window_has_one_thread_and_sleeps() {
    let Some(window) = start("show painter") else {
        return;
    };
    let process = Path::new("/proc").join(window.program.id().to_string());
    wait_for("the end of other threads", || {
        let threads = process.join("task").read_dir().unwrap().count();
        (threads == 1 && window.state().contains("finished: true")).then_some(())
    });
    // How often the thread has waited for something.
    let waits = || -> u64 {
        let status = fs::read_to_string(process.join("status")).unwrap();
        let line = status
            .lines()
            .find_map(|line| line.strip_prefix("voluntary_ctxt_switches:"));
        line.unwrap().trim().parse().unwrap()
    };
    // Events of the display may follow the last drawing.
    thread::sleep(Duration::from_secs(1));
    let before = waits();
    thread::sleep(Duration::from_secs(3));
    assert!(waits() - before <= 3, "it woke {} times", waits() - before);
}
