//! `Input`: what a person has done with keyboard and mouse since the last look.

use std::cell::RefCell;
use std::rc::Rc;

use minifb::{InputCallback, Key, MouseButton, MouseMode, Window};

/// Something that a person has done.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// A key was pressed.
    Key(Key),
    /// The left button was pressed.
    Click,
    /// The wheel was turned, by 1 upwards or -1.
    Wheel(i32),
    /// The mouse was moved with the right button down, by this way to the right and down.
    Drag([i32; 2]),
    /// The mouse was moved.
    Move,
}

/// Keyboard and mouse at the last look.
#[derive(Default)]
pub struct Input {
    keys: Keys,
    /// The place of the mouse, in pixels from the upper left corner of the window.
    pub at: [i32; 2],
    left: bool,
    right: bool,
}

impl Input {
    /// The input of a window.
    pub fn of(window: &mut Window) -> Self {
        let input = Self::default();
        window.set_input_callback(Box::new(input.keys.clone()));
        input
    }

    /// The events since the last call, from the state in which the last update left the window.
    pub fn events(&mut self, window: &Window) -> Vec<Event> {
        let mut events = Vec::new();
        let before = self.at;
        if let Some((x, y)) = window.get_mouse_pos(MouseMode::Pass) {
            self.at = [x as i32, y as i32];
        }
        let way = [self.at[0] - before[0], self.at[1] - before[1]];
        let was_left = std::mem::replace(&mut self.left, window.get_mouse_down(MouseButton::Left));
        let was_right =
            std::mem::replace(&mut self.right, window.get_mouse_down(MouseButton::Right));
        if way != [0; 2] {
            let is_drag = self.right && was_right;
            events.push(if is_drag {
                Event::Drag(way)
            } else {
                Event::Move
            });
        }
        if self.left && !was_left {
            events.push(Event::Click);
        }
        if let Some((_, way)) = window.get_scroll_wheel() {
            // Systems differ in the length of a step.
            events.push(Event::Wheel(if way > 0.0 { 1 } else { -1 }));
        }
        let keys = self.keys.take(window.is_active());
        events.extend(keys.into_iter().map(Event::Key));
        events
    }
}

/// The keys, which minifb reports one by one, so that none is lost between two looks.
#[derive(Clone, Default)]
struct Keys(Rc<RefCell<PressedKeys>>);

#[derive(Default)]
struct PressedKeys {
    held: Vec<Key>,
    new: Vec<Key>,
}

impl Keys {
    /// The keys that were pressed since the last call.
    fn take(&self, is_active: bool) -> Vec<Key> {
        let mut keys = self.0.borrow_mut();
        if !is_active {
            // Another window is told when they are released.
            keys.held.clear();
        }
        std::mem::take(&mut keys.new)
    }
}

impl InputCallback for Keys {
    fn add_char(&mut self, _: u32) {}

    fn set_key_state(&mut self, key: Key, is_down: bool) {
        let mut keys = self.0.borrow_mut();
        let was_held = keys.held.contains(&key);
        keys.held.retain(|held| *held != key);
        if !is_down {
            return;
        }
        // A key that is held repeats itself. With these it is a command of the desktop.
        let of_desktop = [Key::LeftAlt, Key::RightAlt, Key::LeftSuper, Key::RightSuper];
        let is_command = keys.held.iter().any(|held| of_desktop.contains(held));
        if !was_held && !is_command {
            keys.new.push(key);
        }
        keys.held.push(key);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_counts_once_until_it_is_released() {
        let mut keys = Keys::default();
        for key in [Key::S, Key::S, Key::H] {
            keys.set_key_state(key, true);
        }
        assert_eq!(keys.take(true), [Key::S, Key::H]);
        keys.set_key_state(Key::S, false);
        keys.set_key_state(Key::S, true);
        assert_eq!(keys.take(true), [Key::S]);
        // The release of H is lost with the keyboard.
        assert_eq!(keys.take(false), []);
        keys.set_key_state(Key::H, true);
        keys.set_key_state(Key::LeftAlt, true);
        keys.set_key_state(Key::R, true);
        assert_eq!(keys.take(true), [Key::H, Key::LeftAlt]);
    }
}
