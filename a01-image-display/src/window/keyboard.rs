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
    commands: Vec<Command>,
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
    fn add_char(&mut self, code: u32) {
        let command = char::from_u32(code).and_then(Command::of_character);
        self.0.borrow_mut().commands.extend(command);
    }

    fn set_key_state(&mut self, key: Key, down: bool) {
        let mut typed = self.0.borrow_mut();
        let was_down = typed.down.contains(&key);
        typed.down.retain(|other| *other != key);
        if !down {
            return;
        }
        typed.down.push(key);
        let ctrl = typed.down.contains(&Key::LeftCtrl) || typed.down.contains(&Key::RightCtrl);
        // A held key repeats itself; its command is executed once.
        let command = Command::of_key(key, ctrl).filter(|_| !was_down);
        typed.commands.extend(command);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The window's tests press keys; these cases need two of them or a held one.
    #[test]
    fn a_held_key_counts_once_and_either_ctrl_counts_while_it_is_down() {
        let mut keyboard = Keyboard::default();
        let (left, right) = (Key::LeftCtrl, Key::RightCtrl);
        for (key, down, command) in [
            (Key::S, true, Some(Command::Save)),
            (Key::S, true, None),
            (Key::S, false, None),
            (Key::W, true, None),
            (Key::W, false, None),
            (left, true, None),
            (right, true, None),
            (left, false, None),
            (Key::W, true, Some(Command::Close)),
            (Key::W, false, None),
            (right, false, None),
            (Key::W, true, None),
        ] {
            keyboard.set_key_state(key, down);
            assert!(keyboard.take().into_iter().eq(command), "{key:?} {down}");
        }
    }
}
