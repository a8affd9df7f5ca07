//! `Window`: shows pictures on the screen.

use std::cell::Cell;
use std::rc::Rc;

use common::{NoWindow, Size, Viewer};
use minifb::{InputCallback, Key, ScaleMode, WindowOptions};

/// Width and height that fit on most screens, their bars included.
const LARGEST: (u32, u32) = (1600, 1000);

/// Width and height that leave room for the title and something to grasp.
const SMALLEST: (u32, u32) = (160, 120);

/// A window that its reader can resize, and closes with Esc.
#[derive(Clone, Copy, Debug, Default)]
pub struct Window;

impl Viewer for Window {
    fn show(&self, title: &str, size: Size, pixels: &[u32]) -> Result<(), NoWindow> {
        let options = WindowOptions {
            resize: true,
            scale_mode: ScaleMode::AspectRatioStretch,
            ..WindowOptions::default()
        };
        let (width, height) = window_size(size);
        let mut window = minifb::Window::new(title, width, height, options).map_err(explain)?;
        window.set_target_fps(60);
        let escape = Escape::default();
        window.set_input_callback(Box::new(escape.clone()));
        while window.is_open() && !escape.pressed() {
            let (width, height) = (size.width() as usize, size.height() as usize);
            window
                .update_with_buffer(pixels, width, height)
                .map_err(explain)?;
        }
        Ok(())
    }
}

/// Notes whether Esc was pressed. The window's own list of keys forgets a key
/// that was pressed and released between two frames.
#[derive(Clone, Default)]
struct Escape(Rc<Cell<bool>>);

impl Escape {
    fn pressed(&self) -> bool {
        self.0.get()
    }
}

impl InputCallback for Escape {
    fn add_char(&mut self, _: u32) {}

    fn set_key_state(&mut self, key: Key, down: bool) {
        if key == Key::Escape && down {
            self.0.set(true);
        }
    }
}

/// The picture's width and height, shrunk where a side is too long for the
/// screen; never smaller than what a person can handle.
fn window_size(picture: Size) -> (usize, usize) {
    let (width, height) = (f64::from(picture.width()), f64::from(picture.height()));
    let fit = (f64::from(LARGEST.0) / width).min(f64::from(LARGEST.1) / height);
    let side = |side: f64, smallest: u32| {
        let fitting = (side * fit.min(1.0)).round();
        fitting.max(f64::from(smallest)) as usize
    };
    (side(width, SMALLEST.0), side(height, SMALLEST.1))
}

fn explain(error: minifb::Error) -> NoWindow {
    NoWindow(match error {
        minifb::Error::WindowCreate(reason) => format!("no display to open it on ({reason})"),
        error => format!("the display refused the picture ({error})"),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sides(width: u32, height: u32) -> (usize, usize) {
        window_size(Size::new(width, height).unwrap())
    }

    #[test]
    fn a_picture_that_fits_is_shown_as_it_is() {
        assert_eq!(sides(640, 480), (640, 480));
        assert_eq!(sides(1600, 1000), (1600, 1000));
    }

    #[test]
    fn a_larger_picture_keeps_its_proportions() {
        assert_eq!(sides(3200, 1000), (1600, 500));
        assert_eq!(sides(8000, 8000), (1000, 1000));
    }

    #[test]
    fn no_window_is_too_small_to_be_seen() {
        assert_eq!(sides(1, 1), (160, 120));
        assert_eq!(sides(32_768, 1), (1600, 120));
        assert_eq!(sides(1, 32_768), (160, 1000));
    }

    #[test]
    fn one_press_of_escape_is_remembered() {
        let escape = Escape::default();
        let mut callback = escape.clone();
        callback.set_key_state(Key::A, true);
        callback.set_key_state(Key::Escape, false);
        assert!(!escape.pressed());
        callback.set_key_state(Key::Escape, true);
        callback.set_key_state(Key::Escape, false);
        assert!(escape.pressed());
    }
}
