//! The menu, by keyboard and by mouse.

use testing::display::{Display, Picture, RunningProgram, wait_for};

use super::{file_name, folder, locked, open, program, wait_for_picture};

const SELECTED: u32 = 0x3D_5A80;

fn wait_for_menu(window: &RunningProgram, selected: u32) {
    window.wait_to_show("the menu", |look| {
        let is_selected = |line: u32| look.at(0, line * Picture::LINE) == SELECTED;
        let items = look.menu();
        let start =
            |line: usize, start: &str| items.get(line).is_some_and(|i| i.starts_with(start));
        start(0, "Save as PNG ")
            && start(items.len() - 1, "Close ")
            && (1..=items.len() as u32).all(|line| is_selected(line) == (line == 1 + selected))
    });
}

/// Presses the mouse button until that has had its effect, as a hand does,
/// which is slower than a display that nobody sees.
fn click(window: &RunningProgram, x: u32, y: u32, what: &str, effect: impl Fn(&Picture) -> bool) {
    window.point_at(x, y);
    window.settle();
    window.act("mousedown 1");
    window.wait_to_show(what, effect);
    window.act("mouseup 1");
}

#[test]
fn f10_arrows_and_enter_save_and_close() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    let path = folder.path().join("out").join(file_name("painter"));
    let window = display.start(&mut program(folder.path(), "show painter"));
    wait_for_picture(&window, "painter");
    window.press("F10");
    wait_for_menu(&window, 0);
    for (key, selected) in [("Down", 1), ("Down", 0), ("Up", 1), ("Up", 0)] {
        window.press(key);
        wait_for_menu(&window, selected);
    }
    window.press("Return");
    wait_for("the file", || path.exists().then_some(()));
    assert_eq!(open(&path), locked("painter"));
    window.press("F10 Down");
    wait_for_menu(&window, 1);
    window.press("Return");
    assert_eq!(window.wait_for_end(), (Some(0), String::new()));
}

#[test]
fn escape_and_f10_close_the_menu_and_not_the_window() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    let mut window = display.start(&mut program(folder.path(), "show painter"));
    for key in ["Escape", "F10"] {
        window.press("F10");
        wait_for_menu(&window, 0);
        window.press(key);
        wait_for_picture(&window, "painter");
    }
    assert!(window.is_running());
}

#[test]
fn the_mouse_saves_and_closes() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    let path = folder.path().join("out").join(file_name("painter"));
    let window = display.start(&mut program(folder.path(), "show painter"));
    wait_for_picture(&window, "painter");
    let is_open = |look: &Picture| !look.menu().is_empty();
    let line = |line: u32| line * Picture::LINE + Picture::LINE / 2;

    click(&window, 20, 9, "the menu", is_open);
    click(&window, 20, 9, "no menu after a click on File", |look| {
        !is_open(look)
    });
    click(&window, 20, 9, "the menu", is_open);
    click(
        &window,
        400,
        300,
        "no menu after a click beside it",
        |look| !is_open(look),
    );
    assert!(!path.exists());

    click(&window, 20, 9, "the menu", is_open);
    click(&window, 60, line(1), "no menu", |look| !is_open(look));
    wait_for("the file", || path.exists().then_some(()));
    assert_eq!(open(&path), locked("painter"));

    click(&window, 20, 9, "the menu", is_open);
    window.point_at(60, line(2));
    window.settle();
    window.act("mousedown 1");
    assert_eq!(window.wait_for_end(), (Some(0), String::new()));
}

#[test]
fn the_mouse_selects_when_it_moves_and_leaves_the_keys_alone_when_it_rests() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    let window = display.start(&mut program(folder.path(), "show painter"));
    let line = |line: u32| line * Picture::LINE + Picture::LINE / 2;
    window.point_at(60, line(2));
    window.settle();
    window.press("F10");
    wait_for_menu(&window, 0);
    window.press("Down Down");
    wait_for_menu(&window, 0);
    window.point_at(61, line(2));
    wait_for_menu(&window, 1);
    window.point_at(61, line(1));
    wait_for_menu(&window, 0);
}

#[test]
fn a_scene_that_shows_a_file_has_an_item_to_choose_it() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    let window = display.start(&mut program(folder.path(), "show painter"));
    window.press("F10");
    window.wait_to_show("two items", |look| look.menu().len() == 2);
    window.press("Left Right Right F10");
    window.wait_to_show("three items", |look| {
        let items = look.menu();
        items.len() == 3 && items[1].starts_with("Open ...")
    });
}
