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

    #[test]
    fn a_key_that_is_held_counts_once() {
        let mut keyboard = Keyboard::default();
        for (down, expected) in [(true, vec![Command::Save]), (true, vec![]), (false, vec![])] {
            keyboard.set_key_state(Key::S, down);
            assert_eq!(keyboard.take(), expected);
        }
        keyboard.set_key_state(Key::S, true);
        assert_eq!(keyboard.take(), [Command::Save]);
    }

    #[test]
    fn either_ctrl_key_counts_while_it_is_down() {
        let mut keyboard = Keyboard::default();
        let mut press = |down, keys: &[Key]| {
            for key in keys {
                keyboard.set_key_state(*key, down);
            }
            keyboard.take()
        };
        assert_eq!(press(true, &[Key::W]), []);
        press(false, &[Key::W]);
        press(true, &[Key::LeftCtrl, Key::RightCtrl]);
        press(false, &[Key::LeftCtrl]);
        assert_eq!(press(true, &[Key::W]), [Command::Close]);
        press(false, &[Key::W, Key::RightCtrl]);
        assert_eq!(press(true, &[Key::W]), []);
    }

    #[test]
    fn a_key_without_a_reported_release_does_not_stay_down() {
        let mut keyboard = Keyboard::default();
        keyboard.set_key_state(Key::LeftCtrl, true);
        keyboard.release_all();
        keyboard.set_key_state(Key::I, true);
        assert_eq!(keyboard.take(), [Command::Inspect]);
    }

    #[test]
    fn characters_zoom_on_every_keyboard() {
        let mut keyboard = Keyboard::default();
        for character in "+=-0x".chars() {
            keyboard.add_char(character.into());
        }
        keyboard.add_char(u32::MAX);
        let (zoom_in, zoom_out) = (Command::ZoomIn, Command::ZoomOut);
        let expected = [zoom_in, zoom_in, zoom_out, Command::ZoomReset];
        assert_eq!(keyboard.take(), expected);
    }
}
