//! `Keyboard`: collects what is typed until the window asks for it.
//!
//! The window's own list of keys forgets one that is pressed and released
//! between two updates; its callback does not.

use std::cell::RefCell;
use std::rc::Rc;

use minifb::{InputCallback, Key};

use super::command::Command;

/// What has been typed.
#[derive(Clone, Default)]
pub struct Keyboard(Rc<RefCell<Typed>>);

#[derive(Default)]
struct Typed {
    ctrl: bool,
    commands: Vec<Command>,
}

impl Keyboard {
    /// The commands typed since the last call.
    pub fn take(&self) -> Vec<Command> {
        std::mem::take(&mut self.0.borrow_mut().commands)
    }
}

impl InputCallback for Keyboard {
    fn add_char(&mut self, code: u32) {
        let command = char::from_u32(code).and_then(Command::of_character);
        self.0.borrow_mut().commands.extend(command);
    }

    fn set_key_state(&mut self, key: Key, down: bool) {
        let mut typed = self.0.borrow_mut();
        if matches!(key, Key::LeftCtrl | Key::RightCtrl) {
            typed.ctrl = down;
        } else if down {
            let command = Command::of_key(key, typed.ctrl);
            typed.commands.extend(command);
        }
    }
}
