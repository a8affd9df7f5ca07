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

/// Height of the bar.
pub const HEIGHT: i32 = if PLATFORM_HAS_MENU { 0 } else { LINE };

/// The text of an item, the key with the same command, and the command.
type Item = (&'static str, &'static str, Command);

/// The items of the file menu.
pub const ITEMS: [Item; 3] = [
    ("Save as PNG", "S", Command::Save),
    ("Open ...", "Ctrl+O", Command::Open),
    ("Close", "Esc", Command::Close),
];

/// The file menu.
pub struct MenuBar {
    /// The selected item, while the menu is open.
    selected: Option<usize>,
    /// Whether the scene shows a file that can be chosen.
    pub can_open: bool,
}

impl MenuBar {
    pub const fn new(can_open: bool) -> Self {
        let selected = None;
        Self { selected, can_open }
    }

    /// The selected item, while the menu is open.
    pub const fn selected(&self) -> Option<usize> {
        self.selected
    }

    /// The items for this scene.
    fn items(&self) -> Vec<Item> {
        let can_open = |(.., command): &Item| self.can_open || *command != Command::Open;
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
                return Some(items[item].2);
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
        Some(self.items()[item].2)
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
        for (index, (label, key, _)) in self.items().into_iter().enumerate() {
            let line = Self::item(index);
            frame.fill(line, if index == selected { SELECTED } else { BAR });
            frame.text(line.x + LETTER, line.y + 5, TEXT, label);
            let key_x = line.x + WIDTH - LETTER * (1 + key.len() as i32);
            frame.text(key_x, line.y + 5, TEXT, key);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lines are 18 pixels high, the title 48 wide and the items 200.
    #[test]
    fn the_mouse_selects_what_is_drawn_under_it() {
        let (mut menu, mut frame) = (MenuBar::new(true), Frame::default());
        for (x, y) in [(48, 0), (0, 18), (-1, 0), (0, -1)] {
            assert_eq!((menu.click(x, y), menu.selected()), (None, None), "{x} {y}");
        }
        menu.click(47, 17);
        for (x, y, selected) in [
            (0, 18, 0),
            (0, 36, 1),
            (199, 71, 2),
            (200, 18, 2),
            (0, 72, 2),
        ] {
            menu.hover(x, y);
            assert_eq!(menu.selected(), Some(selected), "{x} {y}");
            frame.clear((300, 100), 0);
            menu.draw(&mut frame, 300, "title");
            let color = frame.pixels()[y as usize * 300 + x as usize];
            let is_item = (18..72).contains(&y) && x < 200;
            assert_eq!(color, if is_item { SELECTED } else { 0 }, "{x} {y}");
        }
        assert_eq!(menu.click(199, 71), Some(Command::Close));
        assert_eq!(menu.selected(), None);
    }
}
