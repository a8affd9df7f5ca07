//! The menu, by keyboard and by mouse.

use crate::display::BAR;

use super::{press_and_wait, wait_for_painter_in, wait_for_picture, with_window};

#[test]
fn the_menu_works_by_keyboard() {
    with_window("show painter", |window, folder| {
        let (first, last, closed) = ("menu: Some(0)", "menu: Some(1)", "menu: None");
        press_and_wait(
            &window,
            &[
                ("F10", first),
                ("Down", last),
                ("Down", first),
                ("Up", last),
            ],
        );
        press_and_wait(
            &window,
            &[("Escape", closed), ("F10", first), ("F10", closed)],
        );
        press_and_wait(&window, &[("F10", first), ("h", closed), ("F10", first)]);
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
