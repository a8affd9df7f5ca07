//! `MenuBar`: the menu, drawn in the window.
//!
//! X11 and Wayland leave menus to the programs. Where the platform has a menu
//! of its own, that is used and this one is not shown.

use super::command::Command;
use super::frame::{Area, Frame, LETTER};

/// Whether the platform draws menus.
pub const PLATFORM_HAS_MENU: bool = cfg!(any(windows, target_os = "macos"));

/// Height of the bar and of every line of the menu.
pub const LINE: i32 = 18;

const BAR: u32 = 0x2B_2B2B;
const SELECTED: u32 = 0x3D_5A80;
const TEXT: u32 = 0xE0_E0E0;
const WIDTH: i32 = 200;

/// An item of the menu.
#[derive(Clone, Copy, Debug)]
pub struct Item {
    /// What it says.
    pub label: &'static str,
    /// The key that does the same.
    key: &'static str,
    /// What it does.
    pub command: Command,
}

/// The items of the file menu.
pub const ITEMS: [Item; 3] = [
    Item {
        label: "Save as PNG",
        key: "S",
        command: Command::Save,
    },
    Item {
        label: "Open ...",
        key: "Ctrl+O",
        command: Command::Open,
    },
    Item {
        label: "Close",
        key: "Esc",
        command: Command::Close,
    },
];

/// The file menu.
#[derive(Debug, Default)]
pub struct MenuBar {
    /// The selected item, while the menu is open.
    selected: Option<usize>,
    can_open: bool,
}

impl MenuBar {
    /// Whether the scene shows a file that can be chosen.
    pub const fn set_can_open(&mut self, can_open: bool) {
        self.can_open = can_open;
    }

    /// The selected item, while the menu is open.
    pub const fn selected(&self) -> Option<usize> {
        self.selected
    }

    /// The items that there are for this scene.
    fn items(&self) -> Vec<Item> {
        let can_open = |item: &Item| self.can_open || item.command != Command::Open;
        ITEMS.into_iter().filter(can_open).collect()
    }

    const fn title() -> Area {
        Area {
            x: 0,
            y: 0,
            width: 6 * LETTER,
            height: LINE,
        }
    }

    const fn item(index: usize) -> Area {
        Area {
            x: 0,
            y: LINE * (1 + index as i32),
            width: WIDTH,
            height: LINE,
        }
    }

    /// Handles a command that concerns the menu. What is left is for the window.
    pub fn handle(&mut self, command: Command) -> Option<Command> {
        let items = self.items();
        let count = items.len();
        match (command, self.selected) {
            (Command::Menu, None) => self.selected = Some(0),
            (Command::Menu | Command::Escape, Some(_)) => self.selected = None,
            (Command::Escape, None) => return Some(Command::Close),
            (Command::Down, Some(item)) => self.selected = Some((item + 1) % count),
            (Command::Up, Some(item)) => self.selected = Some((item + count - 1) % count),
            (Command::Choose, Some(item)) => {
                self.selected = None;
                return items.get(item).map(|item| item.command);
            }
            (Command::Up | Command::Down | Command::Choose, None) => {}
            (command, _) => {
                self.selected = None;
                return Some(command);
            }
        }
        None
    }

    /// The item under the cursor.
    fn item_at(&self, x: i32, y: i32) -> Option<usize> {
        (0..self.items().len()).find(|index| Self::item(*index).contains(x, y))
    }

    /// Selects the item under the cursor.
    pub fn hover(&mut self, x: i32, y: i32) {
        if self.selected.is_some() {
            self.selected = self.item_at(x, y).or(self.selected);
        }
    }

    /// Handles a click.
    pub fn click(&mut self, x: i32, y: i32) -> Option<Command> {
        if Self::title().contains(x, y) {
            return self.handle(Command::Menu);
        }
        self.selected.take()?;
        let item = self.item_at(x, y)?;
        Some(self.items()[item].command)
    }

    /// Draws the bar, and the menu if it is open.
    pub fn draw(&self, frame: &mut Frame, width: i32, title: &str) {
        let bar = Area {
            width,
            ..Self::title()
        };
        frame.fill(bar, BAR);
        if self.selected.is_some() {
            frame.fill(Self::title(), SELECTED);
        }
        frame.text(LETTER, 5, TEXT, "File");
        frame.text(Self::title().width + LETTER, 5, 0x90_9090, title);
        let Some(selected) = self.selected else {
            return;
        };
        for (index, item) in self.items().into_iter().enumerate() {
            let line = Self::item(index);
            frame.fill(line, if index == selected { SELECTED } else { BAR });
            frame.text(line.x + LETTER, line.y + 5, TEXT, item.label);
            let key_x = line.x + WIDTH - LETTER * (1 + item.key.len() as i32);
            frame.text(key_x, line.y + 5, TEXT, item.key);
        }
    }
}

#[cfg(test)]
mod tests {
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

    /// What an item says begins a letter from the left, and its key ends a letter
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
}
