//! The effect of each key and of the menu.

use crate::display::{BAR, picture};

use super::with_window;
use super::{close, locked, packed, wait_for_painter_in, wait_for_picture, wait_for_text};

/// Pairs of a key and its effect, with commas between them.
fn in_steps(text: &str) -> impl Iterator<Item = (&str, &str)> {
    let steps = text.split(", ");
    steps.map(|step| step.split_once(' ').expect("a key and its effect"))
}

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
        let steps =
            "Right painter, Right show-image, Right diagonal, Left show-image, Left painter";
        for (key, scene) in in_steps(steps) {
            window.press(key);
            wait_for_picture(&window, scene);
        }
        window.press("s");
        wait_for_painter_in(folder);
    });
}

#[test]
fn i_shows_column_row_and_colour_under_the_mouse_and_h_the_keys() {
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
        for keys in ["h F1", "F1 h"] {
            let (shown, hidden) = keys.split_once(' ').unwrap();
            window.press(shown);
            wait_for_text(&window, HELP);
            window.press(hidden);
            window.wait_for(&["texts: []"]);
        }
    });
}

#[test]
fn plus_minus_and_0_zoom() {
    let painter = locked("painter");
    with_window("show painter", |window, _| {
        // Outside of the window, so that its middle stays in place.
        window.act("mousemove 1500 1200");
        window.wait_for(&["cursor: None"]);
        for (key, factor) in in_steps("plus 2, equal 3, minus 2, 0 1, KP_Add 2, minus 1") {
            window.press(key);
            let factor: u32 = factor.parse().unwrap();
            let at = |side: u32, at: u32| (side / 2 * (factor - 1) + at) / factor;
            let around_the_middle = |x, y| packed(&painter, at(640, x), at(480, y));
            window.wait_for(&[&picture(640, 480, around_the_middle)]);
        }
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

#[test]
fn the_menu_works_by_keyboard() {
    with_window("show painter", |window, folder| {
        let keys = "F10 Some(0), Down Some(1), Down Some(0), Up Some(1), Escape None, \
                    F10 Some(0), F10 None, F10 Some(0), h None, F10 Some(0)";
        for (key, selected) in in_steps(keys) {
            window.press(key);
            window.wait_for(&[&format!("menu: {selected}")]);
        }
        window.press("Return");
        wait_for_painter_in(folder);
        // The next scene shows a file, so there is an item more.
        window.press("Right F10 Up");
        window.wait_for(&["menu: Some(2)"]);
        window.press("Return");
        window.wait_for_end();
    });
}

#[test]
fn the_menu_works_by_mouse() {
    with_window("show painter", |window, folder| {
        wait_for_picture(&window, "painter");
        let line = |line: u32| line * BAR + BAR / 2;
        // The program sees no click that begins and ends between two turns of its loop.
        let click = |x, y| {
            window.point_at(x, y);
            window.act("mousedown 1");
            window.wait_for(&["is_down: true"]);
            window.act("mouseup 1");
            window.wait_for(&["is_down: false"]);
        };
        for beside in [(20, 9), (400, 300)] {
            click(20, 9);
            window.wait_for(&["menu: Some(0)"]);
            click(beside.0, beside.1);
            window.wait_for(&["menu: None"]);
        }
        assert!(!folder.join("out").exists());
        click(20, 9);
        click(60, line(1));
        wait_for_painter_in(folder);

        // A mouse that moves selects; one that rests leaves the menu to the keys.
        window.point_at(60, line(2));
        window.press("F10");
        window.wait_for(&["menu: Some(0)"]);
        for (y, selected) in [(2, 1), (1, 0), (2, 1)] {
            window.point_at(61, line(y));
            window.wait_for(&[&format!("menu: Some({selected})")]);
        }
        window.act("mousedown 1");
        window.wait_for_end();
    });
}
