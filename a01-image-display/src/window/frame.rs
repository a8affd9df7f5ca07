//! `Frame`: the pixels of the window.

use crate::font::dots;

/// Width and height of a character.
pub const LETTER: i32 = 8;

/// Height of the menu bar, of the items of the menu and of the lines below the picture.
pub const LINE: i32 = 18;

/// A part of the window, in pixels from its upper left corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Area {
    pub x: i32,
    pub y: i32,
    pub width: i32,
    pub height: i32,
}

impl Area {
    pub const fn new(x: i32, y: i32, width: i32, height: i32) -> Self {
        Self {
            x,
            y,
            width,
            height,
        }
    }

    /// A line of text below the row `y`, from the left edge of the window.
    pub const fn line(y: i32, width: i32) -> Self {
        Self::new(0, y, width, LINE)
    }

    /// Whether a place lies inside.
    pub const fn contains(self, x: i32, y: i32) -> bool {
        self.x <= x && x < self.x + self.width && self.y <= y && y < self.y + self.height
    }
}

/// Packed 0xRRGGBB pixels. Drawing is clipped to the frame.
#[derive(Default)]
pub struct Frame {
    width: i32,
    height: i32,
    pixels: Vec<u32>,
}

impl Frame {
    /// Fills the frame, at the current size of the window, with one colour.
    pub fn clear(&mut self, (width, height): (usize, usize), color: u32) {
        (self.width, self.height) = (width as i32, height as i32);
        self.pixels.clear();
        self.pixels.resize(width * height, color);
    }

    /// All pixels, row after row from the top.
    pub fn pixels(&self) -> &[u32] {
        &self.pixels
    }

    /// Paints an area, each pixel in the colour of its place, if it has one.
    pub fn paint(&mut self, area: Area, color: impl Fn(i32, i32) -> Option<u32>) {
        for y in area.y.max(0)..(area.y + area.height).min(self.height) {
            for x in area.x.max(0)..(area.x + area.width).min(self.width) {
                if let Some(color) = color(x, y) {
                    self.pixels[(y * self.width + x) as usize] = color;
                }
            }
        }
    }

    /// Fills an area with one colour.
    pub fn fill(&mut self, area: Area, color: u32) {
        self.paint(area, |_, _| Some(color));
    }

    /// Writes one row of text from its upper left corner.
    pub fn text(&mut self, x: i32, y: i32, color: u32, text: &str) {
        for (column, row) in dots(text) {
            self.fill(Area::new(x + column as i32, y + row as i32, 1, 1), color);
        }
    }
}
