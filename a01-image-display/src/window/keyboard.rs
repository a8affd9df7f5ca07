//! `Keyboard`: collects key presses until the window reads them.
//!
//! The window's own list of keys forgets one that is pressed and released
//! between two updates; its callback does not.

use std::cell::RefCell;
use std::rc::Rc;

use minifb::{InputCallback, Key};

use super::command::Command;

/// The collected key presses.
#[derive(Clone, Default)]
pub struct Keyboard(Rc<RefCell<Typed>>);

#[derive(Default)]
struct Typed {
    down: Vec<Key>,
    /// Whether the last key is held and repeats itself.
    repeats: bool,
    commands: Vec<Command>,
}

impl Typed {
    fn is_down(&self, keys: [Key; 2]) -> bool {
        keys.iter().any(|key| self.down.contains(key))
    }
}

impl Keyboard {
    /// The commands typed since the last call.
    pub fn take(&self) -> Vec<Command> {
        std::mem::take(&mut self.0.borrow_mut().commands)
    }

    /// Forgets which keys are down.
    pub fn release_all(&self) {
        self.0.borrow_mut().down.clear();
    }
}

impl InputCallback for Keyboard {
    /// A character of the key whose state came last.
    fn add_char(&mut self, code: u32) {
        let mut typed = self.0.borrow_mut();
        let ctrl = typed.is_down([Key::LeftCtrl, Key::RightCtrl]);
        let character = char::from_u32(code).filter(|_| !typed.repeats);
        let command = character.and_then(|c| Command::of_character(c, ctrl));
        typed.commands.extend(command);
    }

    fn set_key_state(&mut self, key: Key, down: bool) {
        let mut typed = self.0.borrow_mut();
        let length = typed.down.len();
        typed.down.retain(|other| *other != key);
        typed.repeats = down && typed.down.len() < length;
        if down {
            typed.down.push(key);
            let ctrl = typed.is_down([Key::LeftCtrl, Key::RightCtrl]);
            let shift = typed.is_down([Key::LeftShift, Key::RightShift]);
            typed.commands.extend(Command::of_key(key, ctrl, shift));
        }
    }
}
