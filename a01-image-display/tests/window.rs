//! The window on a display of its own: the effect of keys and clicks. Where Xvfb, xdotool or a library
//! of windows is missing nothing is tested, and a line says so.

#![cfg(all(target_os = "linux", feature = "window"))]

use std::path::Path;
use std::time::Duration;
use std::{fs, thread};

use common::picture_file;
use testing::display::{Display, run_at_depth};

const PROGRAM: &str = env!("CARGO_BIN_EXE_a01-image-display");

/// The program with its window; none where it cannot be tested.
fn start(line: &str) -> Option<Display> {
    Display::start(PROGRAM, line)
}

/// Waits for the saved picture of a scene, which must be the one that the book shows.
fn assert_saved(window: &Display, scene: &str) {
    let name = format!("a01-image-display-{scene}.png");
    window.wait_for_line(&format!("saved out/{name}"));
    let pictures = concat!(env!("CARGO_MANIFEST_DIR"), "/../book/src/pictures");
    let saved = picture_file::open(&window.folder.path().join("out").join(&name)).unwrap();
    let locked = picture_file::open(&Path::new(pictures).join(&name)).unwrap();
    assert_eq!(saved, locked);
}

#[test]
fn keys_save_close_and_go_round_the_scenes() {
    let Some(window) = start("") else { return };
    for (key, scene) in [
        ("w", "diagonal"),
        ("Right", "painter"),
        ("Right", "show-image"),
        ("Right", "diagonal"),
        ("Left", "show-image"),
        ("Left", "painter"),
    ] {
        window.act(&format!("key {key}"));
        window.wait_for_picture(&format!("a01-image-display: {scene}, "));
    }
    // With this key, letters are commands of the desktop.
    window.act("key alt+s");
    window.act("key s");
    assert_saved(&window, "painter");
    assert_eq!(window.printed("stdout").lines().count(), 1);
    window.act("key Escape");
    window.wait_for_end();
}

/// S has the number 39 with the letters of any country. Where it is no Latin letter,
/// the menu does the same.
#[test]
fn keyboards_of_five_countries_save_and_close() {
    for (country, is_latin) in [
        ("us", true),
        ("de", true),
        ("fr", true),
        ("ru", false),
        ("gr", false),
    ] {
        let window = Display::start_with_keyboard(country, PROGRAM, "show painter");
        let Some(window) = window else { return };
        window.wait_for_picture("painter");
        if is_latin {
            window.act("key 39");
        } else {
            window.click_until(30, 15, "saved");
        }
        assert_saved(&window, "painter");
        window.act("key Escape");
        window.wait_for_end();
    }
}

/// The entries stand above the picture, at 8 pixels for a letter.
#[test]
fn the_menu_saves_and_closes_by_mouse() {
    let Some(window) = start("show painter") else {
        return;
    };
    window.wait_for_picture("painter");
    window.click_until(30, 15, "saved");
    assert_saved(&window, "painter");
    // The middle of the picture, which is red.
    let explained = "painter 640x480, pixel 320,240\nbytes [255, 0, 0]";
    window.click_until(320, 30 + 240, explained);
    window.act("windowsize --sync WINDOW 1 1");
    window.act("windowsize --sync WINDOW 800 600");
    window.act("mousemove --window WINDOW 380 15 sleep 0.3 mousedown 1");
    window.wait_for_end();
}

#[test]
fn a_picture_is_shown_where_no_file_is_chosen_and_nothing_is_lost() {
    let Some(window) = start("show show-image") else {
        return;
    };
    window.wait_for_picture("show-image");
    let out = window.folder.path().join("out");
    fs::write(&out, "a letter").unwrap();
    window.act("key s e");
    window.wait_for_line("show-image 640x480, pixel");
    assert_eq!(fs::read_to_string(&out).unwrap(), "a letter");
    fs::remove_file(&out).unwrap();
    window.act("key s");
    assert_saved(&window, "show-image");
}

#[test]
fn an_idle_window_has_one_thread_and_sleeps() {
    let Some(window) = start("show painter") else {
        return;
    };
    window.wait_for_picture("painter");
    let process = Path::new("/proc").join(window.program.id().to_string());
    // How often the thread has waited for something.
    let waits = || -> u64 {
        let status = fs::read_to_string(process.join("status")).unwrap();
        let line = status
            .lines()
            .find_map(|line| line.strip_prefix("voluntary_ctxt_switches:"));
        line.unwrap().trim().parse().unwrap()
    };
    // Two seconds after the last movement of the mouse, a window without the keyboard asks for events 10
    // times in a second, and waits several times for each answer of the display. One that is used asks 60
    // times, 120 in these two seconds.
    window.act("windowunmap --sync WINDOW");
    thread::sleep(Duration::from_secs(3));
    let before = waits();
    thread::sleep(Duration::from_secs(2));
    let waited = waits() - before;
    assert!(waited < 120, "it woke {waited} times");
    let threads = process.join("task").read_dir().unwrap().count();
    assert_eq!(threads, 1);
}

/// A pixel of depth 30 has 32 bits, as one of depth 24 has, but ten for each colour.
#[test]
fn colours_of_other_than_24_bits_get_the_picture_in_a_file() {
    for depth in [8, 16, 30] {
        let Some((output, folder)) = run_at_depth(depth, PROGRAM, "show painter --size 8x6") else {
            return;
        };
        let reason = String::from_utf8_lossy(&output.stderr);
        let sentence = format!(
            "no window: no display with colours of 24 bits to open it on (it has {depth})\n"
        );
        assert_eq!((output.status.code(), &*reason), (Some(0), &*sentence));
        let out = folder.path().join("out");
        assert!(out.join("a01-image-display-painter.png").exists());
    }
}
