//! `Surface`: the window of the system, and its pixels.

use std::num::NonZeroU32;
use std::rc::Rc;

use softbuffer::{Context, SoftBufferError};
use winit::dpi::PhysicalSize;
use winit::event_loop::{ActiveEventLoop, OwnedDisplayHandle};
use winit::window::Window;

/// The smallest window in which the panel has room, at scale 1.
const LEAST: [f64; 2] = [320.0, 190.0];

/// A window, into which pictures of its size are brought.
pub struct Surface {
    pub window: Rc<Window>,
    pixels: softbuffer::Surface<OwnedDisplayHandle, Rc<Window>>,
    title: String,
}

impl Surface {
    /// Opens a window of this size. The error is a clause.
    pub fn open(
        event_loop: &ActiveEventLoop,
        title: String,
        [width, height]: [u32; 2],
        scale: f64,
    ) -> Result<Self, String> {
        let least = LEAST.map(|side| (side * scale) as u32);
        let attributes = Window::default_attributes()
            .with_title(title.as_str())
            .with_inner_size(PhysicalSize::new(width, height))
            .with_min_inner_size(PhysicalSize::new(least[0], least[1]));
        let window = event_loop.create_window(attributes);
        let window = Rc::new(window.map_err(|error| error.to_string())?);
        let explain = |error: SoftBufferError| error.to_string();
        let context = Context::new(event_loop.owned_display_handle()).map_err(explain)?;
        let pixels = softbuffer::Surface::new(&context, Rc::clone(&window)).map_err(explain)?;
        Ok(Self {
            window,
            pixels,
            title,
        })
    }

    /// Shows a title, if it is another one.
    pub fn set_title(&mut self, title: String) {
        if self.title != title {
            self.window.set_title(&title);
            self.title = title;
        }
    }

    /// Shows packed 0xRRGGBB pixels, row after row from the top. A window without pixels shows
    /// none. The error is a clause.
    pub fn show(&mut self, [width, height]: [u32; 2], pixels: &[u32]) -> Result<(), String> {
        let (Some(width), Some(height)) = (NonZeroU32::new(width), NonZeroU32::new(height)) else {
            return Ok(());
        };
        let shown = self.pixels.resize(width, height).and_then(|()| {
            let mut buffer = self.pixels.buffer_mut()?;
            for (to, from) in buffer.iter_mut().zip(pixels) {
                *to = *from;
            }
            self.window.pre_present_notify();
            buffer.present()
        });
        shown.map_err(|error| error.to_string())
    }
}
