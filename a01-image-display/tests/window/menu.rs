//! The menu, by keyboard and by mouse.

use testing::display::{Picture, Shown};

use super::{wait_for_painter_in, wait_for_picture, with_window};

const SELECTED: u32 = 0x3D_5A80;

fn wait_for_menu(window: &Shown, items: &[[&str; 2]], selected: u32) {
    window.wait_to_show("the menu", |look| {
        let is_selected = |line: u32| look.at(0, line * Picture::LINE) == SELECTED;
        let lines = look.menu();
        let mut pairs = lines.iter().zip(items);
        lines.len() == items.len()
            && pairs.all(|(line, [label, key])| line.starts_with(label) && line.ends_with(key))
            && (1..=lines.len() as u32).all(|line| is_selected(line) == (line == 1 + selected))
    });
}

const SAVE: [&str; 2] = ["Save as PNG ", " S"];
const OPEN: [&str; 2] = ["Open ... ", " Ctrl+O"];
const CLOSE: [&str; 2] = ["Close ", " Esc"];

#[test]
fn the_menu_works_by_keyboard() {
    with_window("show painter", |window, folder| {
        for (keys, selected) in [("F10", 0), ("Down", 1), ("Down", 0), ("Up", 1)] {
            window.press(keys);
            wait_for_menu(&window, &[SAVE, CLOSE], selected);
        }
        window.press("Escape");
        wait_for_picture(&window, "painter");
        window.press("F10 Return");
        wait_for_painter_in(folder);
        // The next scene shows a file.
        window.press("Right F10");
        wait_for_menu(&window, &[SAVE, OPEN, CLOSE], 0);
        window.press("Up Return");
        assert_eq!(window.wait_for_end(), (Some(0), String::new()));
    });
}

/// Presses the mouse button until the effect is visible, because the program sees no
/// click that begins and ends between two turns of its loop.
fn click(window: &Shown, [x, y]: [u32; 2], what: &str, effect: impl Fn(&Picture) -> bool) {
    window.point_at(x, y);
    window.settle();
    window.act("mousedown 1");
    window.wait_to_show(what, effect);
    window.act("mouseup 1");
    window.settle();
}

#[test]
fn the_menu_works_by_mouse() {
    with_window("show painter", |window, folder| {
        wait_for_picture(&window, "painter");
        let is_open = |look: &Picture| !look.menu().is_empty();
        let line = |line: u32| line * Picture::LINE + Picture::LINE / 2;

        for beside in [[20, 9], [400, 300]] {
            click(&window, [20, 9], "the menu", is_open);
            click(&window, beside, "no menu", |look| !is_open(look));
        }
        assert!(!folder.join("out").exists());
        click(&window, [20, 9], "the menu", is_open);
        click(&window, [60, line(1)], "no menu", |look| !is_open(look));
        wait_for_painter_in(folder);

        // A mouse that moves selects; one that rests leaves the menu to the keys.
        window.point_at(60, line(2));
        window.settle();
        window.press("F10");
        wait_for_menu(&window, &[SAVE, CLOSE], 0);
        for (y, selected) in [(2, 1), (1, 0), (2, 1)] {
            window.point_at(61, line(y));
            wait_for_menu(&window, &[SAVE, CLOSE], selected);
        }
        window.act("mousedown 1");
        assert_eq!(window.wait_for_end(), (Some(0), String::new()));
    });
}
