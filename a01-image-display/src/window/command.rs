//! `Command`: the commands of the window, by key or by menu.

use minifb::Key;

/// A command of the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Command {
    Save,
    Open,
    Close,
    Previous,
    Next,
    Inspect,
    ZoomIn,
    ZoomOut,
    ZoomReset,
    Help,
    /// Closes the menu if that is open, else the window.
    Escape,
    /// Opens or closes the menu.
    Menu,
    /// In the open menu.
    Up,
    Down,
    Choose,
}

/// The keys, for the help line.
pub const HELP: &str = "S save  Esc close  <- -> scenes  I inspect  + - 0 zoom  F10 menu  H help";

impl Command {
    /// The command of a key, with or without Ctrl.
    pub const fn of_key(key: Key, ctrl: bool) -> Option<Self> {
        Some(match (key, ctrl) {
            (Key::S, _) => Self::Save,
            (Key::O, true) => Self::Open,
            (Key::W, true) => Self::Close,
            (Key::Escape, _) => Self::Escape,
            (Key::Left, false) => Self::Previous,
            (Key::Right, false) => Self::Next,
            (Key::I, false) => Self::Inspect,
            (Key::H | Key::F1, false) => Self::Help,
            (Key::F10, false) => Self::Menu,
            (Key::Up, false) => Self::Up,
            (Key::Down, false) => Self::Down,
            (Key::Enter | Key::NumPadEnter, false) => Self::Choose,
            _ => return None,
        })
    }

    /// The command of a character. The keys of `+` and `-` depend on the keyboard.
    pub const fn of_character(character: char) -> Option<Self> {
        Some(match character {
            '+' | '=' => Self::ZoomIn,
            '-' => Self::ZoomOut,
            '0' => Self::ZoomReset,
            _ => return None,
        })
    }
}
