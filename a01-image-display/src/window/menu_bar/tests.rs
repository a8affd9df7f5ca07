//! Tests of `menu_bar`.

use super::*;

fn of_three() -> MenuBar {
    MenuBar {
        can_open: true,
        ..MenuBar::default()
    }
}

#[test]
fn the_menu_works_by_keyboard() {
    let mut menu = of_three();
    for (command, selected) in [
        (Command::Down, None),
        (Command::Choose, None),
        (Command::Menu, Some(0)),
        (Command::Down, Some(1)),
        (Command::Down, Some(2)),
        (Command::Down, Some(0)),
        (Command::Up, Some(2)),
        (Command::Up, Some(1)),
        (Command::Menu, None),
        (Command::Up, None),
        (Command::Menu, Some(0)),
        (Command::Escape, None),
        (Command::Menu, Some(0)),
        (Command::Up, Some(2)),
    ] {
        assert_eq!(menu.handle(command), None);
        assert_eq!(menu.selected(), selected, "{command:?}");
    }
    assert_eq!(menu.handle(Command::Choose), Some(Command::Close));
    assert_eq!(menu.handle(Command::Escape), Some(Command::Close));
    // Another command is executed, and closes the menu.
    menu.handle(Command::Menu);
    assert_eq!(menu.handle(Command::Save), Some(Command::Save));
    assert_eq!(menu.selected(), None);
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
        (0, 36, 1),
        (0, 35, 0),
        (199, 54, 2),
        (199, 53, 1),
        (200, 18, 1),
        (0, 72, 1),
        (0, 17, 1),
    ] {
        menu.hover(x, y);
        assert_eq!(menu.selected(), Some(selected), "{x} {y}");
    }
    for (x, y, command) in [
        (199, 71, Some(Command::Close)),
        (0, 36, Some(Command::Open)),
        (0, 72, None),
    ] {
        assert_eq!(menu.click(x, y), command);
        assert_eq!(menu.selected(), None);
        menu.click(0, 0);
    }
}

#[test]
fn the_bar_shows_the_title_and_the_open_menu_its_items() {
    let drawn = |menu: &MenuBar, title: &str| {
        let mut frame = Frame::default();
        frame.clear((300, 100), 0);
        menu.draw(&mut frame, 300, title);
        frame.pixels().to_owned()
    };
    let mut menu = of_three();
    let closed = drawn(&menu, "title");
    assert!(closed != drawn(&menu, "other"));
    assert!(closed[18 * 300..].iter().all(|pixel| *pixel == 0));
    menu.handle(Command::Menu);
    menu.handle(Command::Down);
    let open = drawn(&menu, "title");
    let color_at = |(x, y): (usize, usize)| open[y * 300 + x];
    let (inside, outside) = ([(0, 18), (0, 36), (199, 71)], [(200, 36), (0, 72)]);
    assert_eq!(inside.map(color_at), [BAR, SELECTED, BAR]);
    assert_eq!(outside.map(color_at), [0, 0]);
}
