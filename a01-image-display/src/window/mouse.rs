//! `Mouse`: the state of the mouse.

use minifb::{MouseButton, MouseMode, Window};

/// The way of the wheel for a step: X11 reports a notch twice, when it begins and ends.
const NOTCH: f32 = 2.0;

/// The mouse at one time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mouse {
    /// The pixel of the window under the mouse, which may lie outside.
    pub at: [i32; 2],
    pub left: bool,
    pub right: bool,
    /// The way of the wheel upwards, since the start.
    wheel: f32,
}

impl Mouse {
    /// The mouse now.
    pub fn now(self, window: &Window) -> Self {
        let at = window.get_mouse_pos(MouseMode::Pass);
        Self {
            at: at.map_or(self.at, |(x, y)| [x as i32, y as i32]),
            left: window.get_mouse_down(MouseButton::Left),
            right: window.get_mouse_down(MouseButton::Right),
            wheel: self.wheel + window.get_scroll_wheel().map_or(0.0, |(_, lines)| lines),
        }
    }

    /// The way to the right and down from an earlier place.
    pub const fn way_from(self, before: [i32; 2]) -> [i32; 2] {
        [self.at[0] - before[0], self.at[1] - before[1]]
    }

    /// Steps of the wheel upwards since an earlier time.
    pub fn steps_since(self, before: Self) -> i32 {
        (self.wheel / NOTCH) as i32 - (before.wheel / NOTCH) as i32
    }
}
