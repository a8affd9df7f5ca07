//! `Mouse`: the state of the mouse.

use winit::event::{ElementState, MouseButton, MouseScrollDelta};

/// The way of a touchpad for a line of a wheel, in pixels.
const LINE: f64 = 40.0;

/// The mouse at one time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mouse {
    /// The pixel of the window under the mouse, which may lie outside.
    pub at: [i32; 2],
    pub left: bool,
    pub right: bool,
    /// The way of the wheel upwards, in lines, since the start.
    wheel: f64,
}

impl Mouse {
    /// The mouse after a button has been pressed or released.
    pub fn with_button(mut self, button: MouseButton, state: ElementState) -> Self {
        match button {
            MouseButton::Left => self.left = state.is_pressed(),
            MouseButton::Right => self.right = state.is_pressed(),
            _ => {}
        }
        self
    }

    /// The mouse after its wheel has been turned.
    pub fn with_wheel(mut self, way: MouseScrollDelta) -> Self {
        self.wheel += match way {
            MouseScrollDelta::LineDelta(_, lines) => f64::from(lines),
            MouseScrollDelta::PixelDelta(way) => way.y / LINE,
        };
        self
    }

    /// The way to the right and down from an earlier place.
    pub const fn way_from(self, before: [i32; 2]) -> [i32; 2] {
        [self.at[0] - before[0], self.at[1] - before[1]]
    }

    /// Lines of the wheel upwards since an earlier time.
    pub fn lines_since(self, before: Self) -> i32 {
        self.wheel.floor() as i32 - before.wheel.floor() as i32
    }
}
