//! The smallest window: it shows one picture until it is closed. Take it for programs of your own.

use a01_image_display::PaintDiagonal;
use common::Size;
use minifb::{Key, Window, WindowOptions};

// ANCHOR: window
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (width, height) = (640, 480);
    let image = PaintDiagonal::new(Size::new(width, height)?).image()?;
    let packed: Vec<u32> = image.pixels().iter().map(pack).collect();

    let [width, height] = [width as usize, height as usize];
    let mut window = Window::new("diagonal", width, height, WindowOptions::default())?;
    // It looks for keys and clicks as often in each second.
    window.set_target_fps(30);
    while window.is_open() && !window.is_key_down(Key::Escape) {
        window.update_with_buffer(&packed, width, height)?;
    }
    Ok(())
}

/// A colour as a window takes it.
fn pack(color: &common::Color) -> u32 {
    let [r, g, b] = color.to_bytes().map(u32::from);
    256 * 256 * r + 256 * g + b
}
// ANCHOR_END: window
