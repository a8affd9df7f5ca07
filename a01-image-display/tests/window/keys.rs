//! The effect of each key.

use testing::display::{Picture, Shown};

use super::{close, locked, wait_for_notice, wait_for_painter_in, wait_for_picture, with_window};

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
            wait_for_notice(&window, "saved out/a01-image-display-painter.png");
            std::fs::remove_dir_all(folder.join("out")).unwrap();
        }
        window.press("ctrl+w");
        assert_eq!(window.wait_for_end(), (Some(0), String::new()));
    });
}

#[test]
fn the_arrows_go_round_the_scenes() {
    with_window("", |window, folder| {
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
        wait_for_painter_in(folder);
    });
}

#[test]
fn i_shows_column_row_and_colour_under_the_mouse() {
    with_window("show painter", |window, _| {
        window.point_at(320, 0);
        window.press("i");
        wait_for_notice(&window, "point at the picture");
        // The gradient's ends and the disc in the middle.
        for (x, y, expected) in [
            (639, 0, "column 639, row 0: #00ffff (0, 255, 255)"),
            (320, 240, "column 320, row 240: #ff0000 (255, 0, 0)"),
            (639, 479, "column 639, row 479: #00ff00 (0, 255, 0)"),
        ] {
            window.point_at(x, y + Picture::LINE);
            wait_for_notice(&window, expected);
        }
        window.press("i");
        wait_for_picture(&window, "painter");
    });
}

#[test]
fn plus_minus_and_0_zoom() {
    let picture = locked("painter");
    with_window("show painter", |window, _| {
        // Outside of the window, so that its middle stays in place.
        window.point_at(700, 550);
        window.settle();
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
            let around_the_middle = |x, y| picture.at(at(640, x), at(480, y));
            let expected = Picture::from_fn(640, 480, around_the_middle);
            window.wait_to_show(key, |look| look.below_bar() == expected);
        }
    });
}

#[test]
fn h_and_f1_show_and_hide_the_keys() {
    with_window("show painter", |window, _| {
        for (show, hide) in [("h", "F1"), ("F1", "h")] {
            window.press(show);
            wait_for_notice(&window, HELP);
            window.press(hide);
            wait_for_picture(&window, "painter");
        }
    });
    with_window("show diagonal --size 9x9", |window, _| {
        window.press("h");
        window.wait_to_show("lines of at most 28 characters", |look| {
            look.notices()
                == [
                    "S save  Esc close  <- ->",
                    "scenes  I inspect  + - 0",
                    "zoom  F10 menu  H help",
                ]
        });
    });
}

#[test]
fn ctrl_does_not_stay_down_when_it_is_released_elsewhere() {
    with_window("show painter", |window: Shown, _| {
        window.act("keydown ctrl windowunmap --sync WINDOW");
        window.settle();
        window.act("keyup ctrl windowmap --sync WINDOW");
        window.focus();
        window.press("h");
        wait_for_notice(&window, HELP);
        // The scene shows no file, so there is no hint about one.
        window.press("ctrl+o h");
        wait_for_picture(&window, "painter");
        close(window);
    });
}
