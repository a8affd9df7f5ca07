//! Tests of `menu_bar`.

use super::*;

#[test]
fn the_menu_works_by_keyboard() {
    let mut menu = MenuBar::default();
    assert_eq!(menu.handle(Command::Menu), None);
    assert!(menu.selected().is_some());
    assert_eq!(menu.handle(Command::Down), None);
    assert_eq!(menu.handle(Command::Choose), Some(Command::Close));
    assert_eq!(menu.selected(), None);

    menu.handle(Command::Menu);
    menu.handle(Command::Up);
    menu.handle(Command::Up);
    assert_eq!(menu.handle(Command::Choose), Some(Command::Save));
}

#[test]
fn the_menu_works_by_mouse() {
    let mut menu = MenuBar::default();
    assert_eq!(menu.click(10, 30), None, "closed, there is no item");
    assert_eq!(menu.click(10, 5), None);
    assert!(menu.selected().is_some());
    assert_eq!(menu.click(10, LINE + 5), Some(Command::Save));
    assert_eq!(menu.selected(), None);
    menu.click(10, 5);
    assert_eq!(menu.click(500, 300), None, "beside the menu");
    assert_eq!(menu.selected(), None);
}

#[test]
fn escape_closes_the_menu_before_the_window() {
    let mut menu = MenuBar::default();
    menu.handle(Command::Menu);
    assert_eq!(menu.handle(Command::Escape), None);
    assert_eq!(menu.handle(Command::Escape), Some(Command::Close));
    menu.handle(Command::Menu);
    assert_eq!(menu.handle(Command::Close), Some(Command::Close), "Ctrl+W");
}

#[test]
fn only_a_scene_that_shows_a_file_can_open_one() {
    let mut menu = MenuBar::default();
    let has_open = |menu: &MenuBar| {
        menu.items()
            .iter()
            .any(|item| item.command == Command::Open)
    };
    assert!(!has_open(&menu));
    menu.set_can_open(true);
    assert!(has_open(&menu));
}

fn of_three() -> MenuBar {
    let mut menu = MenuBar::default();
    menu.set_can_open(true);
    menu
}

#[test]
fn up_and_down_go_round() {
    let mut menu = of_three();
    menu.handle(Command::Menu);
    for (command, selected) in [
        (Command::Down, 1),
        (Command::Down, 2),
        (Command::Down, 0),
        (Command::Up, 2),
        (Command::Up, 1),
        (Command::Up, 0),
    ] {
        assert_eq!(menu.handle(command), None);
        assert_eq!(menu.selected(), Some(selected));
    }
    assert_eq!(menu.handle(Command::Menu), None);
    assert_eq!(menu.selected(), None);
    for command in [Command::Up, Command::Down, Command::Choose] {
        assert_eq!(menu.handle(command), None, "closed");
        assert_eq!(menu.selected(), None);
    }
}

/// Lines are 18 pixels high, the title 48 wide and the items 200.
#[test]
fn the_mouse_selects_up_to_the_borders() {
    let mut menu = of_three();
    menu.hover(0, 18);
    assert_eq!(menu.selected(), None, "closed");
    for (x, y) in [(48, 0), (0, 18), (-1, 0), (0, -1)] {
        assert_eq!(menu.click(x, y), None);
        assert_eq!(menu.selected(), None, "{x} {y}");
    }
    for (x, y) in [(47, 17), (0, 0)] {
        menu.click(x, y);
        assert_eq!(menu.selected(), Some(0));
        menu.click(x, y);
        assert_eq!(menu.selected(), None);
    }
    menu.click(0, 0);
    for (x, y, selected) in [
        (0, 35, 0),
        (0, 36, 1),
        (199, 53, 1),
        (199, 54, 2),
        (0, 71, 2),
        (200, 18, 2),
        (0, 72, 2),
        (0, 18, 0),
        (0, 17, 0),
    ] {
        menu.hover(x, y);
        assert_eq!(menu.selected(), Some(selected), "{x} {y}");
    }
    assert_eq!(menu.click(199, 71), Some(Command::Close));
    menu.click(0, 0);
    assert_eq!(menu.click(0, 72), None);
    menu.click(0, 0);
    assert_eq!(menu.click(0, 36), Some(Command::Open));
}

#[test]
fn the_closed_menu_is_a_bar_with_the_title() {
    let (mut drawn, mut expected) = (Frame::default(), Frame::default());
    drawn.clear((300, 100), 0);
    MenuBar::default().draw(&mut drawn, 300, "title");
    expected.clear((300, 100), 0);
    let bar = Area {
        x: 0,
        y: 0,
        width: 300,
        height: 18,
    };
    expected.fill(bar, BAR);
    expected.text(8, 5, TEXT, "File");
    expected.text(56, 5, 0x90_9090, "title");
    assert!(drawn.pixels() == expected.pixels());
}

/// The text of an item begins a letter from the left, and its key ends a letter
/// from the right.
#[test]
fn the_open_menu_has_a_line_for_each_item() {
    let mut menu = of_three();
    menu.handle(Command::Menu);
    menu.handle(Command::Down);
    let (mut drawn, mut expected) = (Frame::default(), Frame::default());
    drawn.clear((300, 100), 0);
    menu.draw(&mut drawn, 300, "title");
    expected.clear((300, 100), 0);
    let mut line = |y, width, color| {
        let area = Area {
            x: 0,
            y,
            width,
            height: 18,
        };
        expected.fill(area, color);
    };
    line(0, 300, BAR);
    line(0, 48, SELECTED);
    line(18, 200, BAR);
    line(36, 200, SELECTED);
    line(54, 200, BAR);
    expected.text(8, 5, TEXT, "File");
    expected.text(56, 5, 0x90_9090, "title");
    for (y, label, key_x, key) in [
        (23, "Save as PNG", 184, "S"),
        (41, "Open ...", 144, "Ctrl+O"),
        (59, "Close", 168, "Esc"),
    ] {
        expected.text(8, y, TEXT, label);
        expected.text(key_x, y, TEXT, key);
    }
    assert!(drawn.pixels() == expected.pixels());
}
