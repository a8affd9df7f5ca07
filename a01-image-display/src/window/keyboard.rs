//! `Keyboard`: collects key presses until the window reads them.
//!
//! The window's own list of keys forgets one that is pressed and released
//! between two updates; its callback does not.

use std::cell::RefCell;
use std::rc::Rc;

use minifb::{InputCallback, Key};

/// The collected key presses.
#[derive(Clone, Default)]
pub struct Keyboard(Rc<RefCell<Typed>>);

#[derive(Default)]
struct Typed {
    down: Vec<Key>,
    /// Whether the last key is held and repeats itself.
    repeats: bool,
    keys: Vec<String>,
}

impl Typed {
    fn add(&mut self, name: &str) {
        let is_down = |keys: [Key; 2]| keys.iter().any(|key| self.down.contains(key));
        let prefix = if is_down([Key::LeftCtrl, Key::RightCtrl]) {
            "Ctrl "
        } else if name.len() > 1 && is_down([Key::LeftShift, Key::RightShift]) {
            "Shift "
        } else {
            ""
        };
        self.keys.push(format!("{prefix}{name}"));
    }
}

impl Keyboard {
    /// The keys pressed since the last call, such as `S`, `Ctrl +` or `Shift Left`.
    pub fn take(&self) -> Vec<String> {
        std::mem::take(&mut self.0.borrow_mut().keys)
    }

    /// Forgets which keys are down.
    pub fn release_all(&self) {
        self.0.borrow_mut().down.clear();
    }
}

impl InputCallback for Keyboard {
    /// A character of the key whose state came last; with Ctrl, a letter is a control character.
    fn add_char(&mut self, code: u32) {
        let mut typed = self.0.borrow_mut();
        let letter = match char::from_u32(code).unwrap_or_default() {
            letter @ '\0'..=' ' => char::from(letter as u8 + b'@'),
            '=' => '+',
            letter => letter.to_ascii_uppercase(),
        };
        if !typed.repeats {
            typed.add(letter.encode_utf8(&mut [0; 4]));
        }
    }

    /// A key without a character has a name of several letters.
    fn set_key_state(&mut self, key: Key, down: bool) {
        let mut typed = self.0.borrow_mut();
        let length = typed.down.len();
        typed.down.retain(|other| *other != key);
        typed.repeats = down && typed.down.len() < length;
        if down {
            typed.down.push(key);
            let name = format!("{key:?}");
            if name.len() > 1 {
                typed.add(name.trim_start_matches("NumPad"));
            }
        }
    }
}
