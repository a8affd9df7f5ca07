//! Every key and its effect.

use std::fs;
use std::time::{Duration, Instant};

use testing::display::{Display, Picture, wait_for};

use super::{file_name, folder, locked, open, program, wait_for_notice, wait_for_picture};

const HELP: &str = "S save  Esc close  <- -> scenes  I inspect  + - 0 zoom  F10 menu  H help";

#[test]
fn s_and_ctrl_s_save() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    let path = folder.path().join("out").join(file_name("painter"));
    let mut window = display.start(&mut program(folder.path(), "show painter"));
    wait_for_picture(&window, "painter");
    for key in ["s", "ctrl+s"] {
        window.press(key);
        wait_for("the file", || path.exists().then_some(()));
        assert_eq!(open(&path), locked("painter"), "{key}");
        fs::remove_file(&path).unwrap();
        wait_for_notice(&window, &format!("saved out/{}", file_name("painter")));
    }
    assert!(window.is_running());
}

#[test]
fn escape_and_ctrl_w_close() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    for key in ["Escape", "ctrl+w", "F10 ctrl+w"] {
        let window = display.start(&mut program(folder.path(), ""));
        // Without Ctrl, W is nobody's key.
        window.press("w");
        wait_for_picture(&window, "diagonal");
        window.press(key);
        assert_eq!(window.wait_for_end(), (Some(0), String::new()), "{key}");
    }
    assert_eq!(folder.path().read_dir().unwrap().count(), 0, "no file");
}

#[test]
fn the_arrows_go_round_the_scenes() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    let window = display.start(&mut program(folder.path(), "show diagonal"));
    for (key, scene) in [
        ("Right", "painter"),
        ("Right", "show-image"),
        ("Right", "diagonal"),
        ("Left", "show-image"),
        ("Left", "painter"),
    ] {
        window.press(key);
        wait_for_picture(&window, scene);
        assert_eq!(window.title(), format!("a01-image-display: {scene}"));
    }
    window.press("s");
    let path = folder.path().join("out").join(file_name("painter"));
    wait_for("the file", || path.exists().then_some(()));
    assert_eq!(open(&path), locked("painter"));
}

#[test]
fn i_tells_column_row_and_colour_under_the_mouse() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    let window = display.start(&mut program(folder.path(), "show painter"));
    wait_for_picture(&window, "painter");
    window.point_at(320, 0);
    window.press("i");
    wait_for_notice(&window, "point at the picture");
    // The gradient's ends and the disc in the middle.
    for (x, y, expected) in [
        (0, 0, "column 0, row 0: #0000ff (0, 0, 255)"),
        (639, 0, "column 639, row 0: #00ffff (0, 255, 255)"),
        (320, 240, "column 320, row 240: #ff0000 (255, 0, 0)"),
        (639, 479, "column 639, row 479: #00ff00 (0, 255, 0)"),
    ] {
        window.point_at(x, y + Picture::LINE);
        wait_for_notice(&window, expected);
    }
    window.press("i");
    wait_for_picture(&window, "painter");
}

#[test]
fn plus_minus_and_0_zoom() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    let picture = locked("painter");
    let window = display.start(&mut program(folder.path(), "show painter"));
    wait_for_picture(&window, "painter");
    // Outside of the window, so that its middle stays in place.
    window.point_at(700, 550);
    window.settle();
    let around_the_middle = |factor: u32| {
        let at = |side: u32, at: u32| side / 2 * (factor - 1) + at;
        Picture::from_fn(640, 480, |x, y| {
            picture.at(at(640, x) / factor, at(480, y) / factor)
        })
    };
    for (key, factor) in [
        ("plus", 2),
        ("plus", 3),
        ("minus", 2),
        ("equal", 3),
        ("0", 1),
        ("KP_Add", 2),
        ("minus", 1),
        ("minus", 1),
    ] {
        window.press(key);
        let expected = around_the_middle(factor);
        window.wait_to_show(key, |look| look.below_bar() == expected);
    }
}

#[test]
fn h_and_f1_show_and_hide_the_keys() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    let window = display.start(&mut program(folder.path(), "show painter"));
    wait_for_picture(&window, "painter");
    for (show, hide) in [("h", "F1"), ("F1", "h")] {
        window.press(show);
        wait_for_notice(&window, HELP);
        window.press(hide);
        wait_for_picture(&window, "painter");
    }
}

#[test]
fn a_line_longer_than_the_window_is_broken() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    let window = display.start(&mut program(folder.path(), "show diagonal --size 9x9"));
    window.press("h");
    window.wait_to_show("three lines of 28 characters", |look| {
        look.notices()
            == [
                "S save  Esc close  <- ->",
                "scenes  I inspect  + - 0",
                "zoom  F10 menu  H help",
            ]
    });
}

#[test]
fn a_key_that_is_held_does_once_what_it_does() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    let window = display.start(&mut program(folder.path(), "show painter"));
    wait_for_picture(&window, "painter");
    window.act("keydown h");
    wait_for_notice(&window, HELP);
    // Keys begin to repeat after half a second or so.
    let start = Instant::now();
    while start.elapsed() < Duration::from_millis(1500) {
        assert_eq!(window.look().notices(), [HELP]);
    }
    window.act("keyup h");
}

#[test]
fn ctrl_does_not_stay_down_when_it_is_released_elsewhere() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    let window = display.start(&mut program(folder.path(), "show painter"));
    wait_for_picture(&window, "painter");
    window.act("keydown ctrl");
    window.hide();
    window.settle();
    window.act("keyup ctrl");
    window.unhide();
    window.press("h");
    wait_for_notice(&window, HELP);
}

#[test]
fn a_scene_without_a_file_asks_for_none() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    let window = display.start(&mut program(folder.path(), "show painter"));
    wait_for_picture(&window, "painter");
    window.press("ctrl+o h");
    let look = window.wait_to_show(HELP, |look| {
        look.notices().last().is_some_and(|line| line == HELP)
    });
    assert_eq!(look.notices(), [HELP]);
}
