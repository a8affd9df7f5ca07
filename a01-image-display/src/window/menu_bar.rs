//! `MenuBar`: the menu, drawn in the window.
//!
//! X11 and Wayland leave menus to the programs. On other platforms the menu of the
//! system replaces this one.

use super::command::Command;
use super::frame::{Area, Frame, LETTER, LINE};

/// Whether the platform draws menus.
pub const PLATFORM_HAS_MENU: bool = cfg!(any(windows, target_os = "macos"));

const BAR: u32 = 0x2B_2B2B;
const SELECTED: u32 = 0x3D_5A80;
const TEXT: u32 = 0xE0_E0E0;
const WIDTH: i32 = 200;

/// An item of the menu.
#[derive(Clone, Copy, Debug)]
pub struct Item {
    /// The text of the item.
    pub label: &'static str,
    /// The key with the same command.
    key: &'static str,
    /// The command of the item.
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
    /// Whether the scene shows a file that can be chosen.
    pub can_open: bool,
}

impl MenuBar {
    /// The selected item, while the menu is open.
    pub const fn selected(&self) -> Option<usize> {
        self.selected
    }

    /// The items for this scene.
    fn items(&self) -> Vec<Item> {
        let can_open = |item: &Item| self.can_open || item.command != Command::Open;
        ITEMS.into_iter().filter(can_open).collect()
    }

    const fn title() -> Area {
        Area::line(0, 6 * LETTER)
    }

    const fn item(index: usize) -> Area {
        Area::line(LINE * (1 + index as i32), WIDTH)
    }

    /// Handles a command that concerns the menu, and returns any other command.
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
        frame.fill(Area::line(0, width), BAR);
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
mod tests;
