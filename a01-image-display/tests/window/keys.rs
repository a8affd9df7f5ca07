//! The effect of each key.

use crate::display::{BAR, picture};

use super::{close, locked, packed, press_and_wait};
use super::{wait_for_painter_in, wait_for_picture, wait_for_text, with_window};

const HELP: &str = "S save  Esc close  <- -> scenes  I inspect  + - 0 zoom  F10 menu  H help";

#[test]
fn s_saves_and_ctrl_w_closes() {
    with_window("show painter", |window, folder| {
        // Without Ctrl, W has no effect.
        window.press("w");
        wait_for_picture(&window, "painter");
        for key in ["s", "ctrl+s"] {
            window.press(key);
            wait_for_painter_in(folder);
            wait_for_text(&window, "saved out/a01-image-display-painter.png");
            std::fs::remove_dir_all(folder.join("out")).unwrap();
        }
        window.press("ctrl+w");
        window.wait_for_end();
    });
}

#[test]
fn the_arrows_go_round_the_scenes() {
    with_window("", |window, folder| {
        wait_for_picture(&window, "diagonal");
        assert_eq!(folder.read_dir().unwrap().count(), 0, "no file");
        for (key, scene) in [
            ("Right", "painter"),
            ("Right", "show-image"),
            ("Right", "diagonal"),
            ("Left", "show-image"),
            ("Left", "painter"),
        ] {
            window.press(key);
            wait_for_picture(&window, scene);
        }
        window.press("s");
        wait_for_painter_in(folder);
    });
}

#[test]
fn i_shows_column_row_and_colour_under_the_mouse() {
    with_window("show painter", |window, _| {
        window.point_at(320, 0);
        window.press("i");
        wait_for_text(&window, "point at the picture");
        // The gradient's ends and the disc in the middle.
        for (x, y, expected) in [
            (639, 0, "column 639, row 0: #00ffff (0, 255, 255)"),
            (320, 240, "column 320, row 240: #ff0000 (255, 0, 0)"),
            (639, 479, "column 639, row 479: #00ff00 (0, 255, 0)"),
        ] {
            window.point_at(x, y + BAR);
            wait_for_text(&window, expected);
        }
        window.press("i");
        wait_for_picture(&window, "painter");
    });
}

#[test]
fn plus_minus_and_0_zoom() {
    let painter = locked("painter");
    with_window("show painter", |window, _| {
        // Outside of the window, so that its middle stays in place.
        window.act("mousemove 1500 1200");
        window.wait_for(&["cursor: None"]);
        for (key, factor) in [
            ("plus", 2),
            ("equal", 3),
            ("minus", 2),
            ("0", 1),
            ("KP_Add", 2),
            ("minus", 1),
        ] {
            window.press(key);
            let at = |side: u32, at: u32| (side / 2 * (factor - 1) + at) / factor;
            let around_the_middle = |x, y| packed(&painter, at(640, x), at(480, y));
            window.wait_for(&[&picture(640, 480, around_the_middle)]);
        }
    });
}

#[test]
fn h_and_f1_show_and_hide_the_keys() {
    with_window("show painter", |window, _| {
        let no_text = "texts: []";
        press_and_wait(
            &window,
            &[("h", HELP), ("F1", no_text), ("F1", HELP), ("h", no_text)],
        );
    });
}

#[test]
fn ctrl_does_not_stay_down_when_it_is_released_elsewhere() {
    with_window("show painter", |window, _| {
        window.act("keydown ctrl windowunmap --sync WINDOW");
        window.wait_for(&["is_active: false"]);
        window.act("keyup ctrl windowmap --sync WINDOW");
        window.focus();
        window.press("h");
        wait_for_text(&window, HELP);
        // The scene shows no file, so there is no hint about one.
        window.press("ctrl+o h");
        wait_for_picture(&window, "painter");
        close(window);
    });
}
