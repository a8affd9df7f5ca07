//! `Picture`: pixels in the format of the screen.

use common::{Image, Transfer};
use font8x8::legacy::BASIC_LEGACY;

/// Packed 0xRRGGBB pixels.
#[derive(Clone, PartialEq, Eq)]
pub struct Picture {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    pixels: Vec<u32>,
}

impl Picture {
    /// The picture whose pixel at column `x` and row `y` is `color(x, y)`.
    pub fn from_fn(width: u32, height: u32, color: impl Fn(u32, u32) -> u32) -> Self {
        let color = &color;
        let row = |y| (0..width).map(move |x| color(x, y));
        Self {
            width,
            height,
            pixels: (0..height).flat_map(row).collect(),
        }
    }

    /// The pixel at column `x` and row `y`.
    #[must_use]
    pub fn at(&self, x: u32, y: u32) -> u32 {
        self.pixels[(y * self.width + x) as usize]
    }
}

/// The text of the window: letters of eight by eight pixels.
impl Picture {
    const LETTER: u32 = 8;
    const INK: u32 = 0xE0_E0E0;
    const STRIP: u32 = 0x2B_2B2B;
    /// Height of the menu bar and of every line.
    pub const LINE: u32 = 18;

    /// The character whose upper left corner is here, if there is one.
    fn letter(&self, x: u32, y: u32) -> Option<char> {
        let row = |row| {
            let is_ink = |dot: &u32| self.at(x + dot, y + row) == Self::INK;
            (0..8).filter(is_ink).map(|dot| 1_u8 << dot).sum()
        };
        let rows: [u8; 8] = [0, 1, 2, 3, 4, 5, 6, 7].map(row);
        let code = (32..127).find(|code| BASIC_LEGACY[*code] == rows)?;
        char::from_u32(code as u32)
    }

    /// The text of the line that begins at this row, up to the right edge.
    fn line(&self, y: u32) -> String {
        let columns = (1..self.width / Self::LETTER).map(|column| column * Self::LETTER);
        let letters = columns.map_while(|x| self.letter(x, y + 5));
        letters.collect::<String>().trim_end().to_owned()
    }

    /// The text of the strips at the bottom, from the upper to the lower.
    #[must_use]
    pub fn notices(&self) -> Vec<String> {
        let bottoms = (1..self.height / Self::LINE).map(|line| self.height - line * Self::LINE);
        let is_strip = |y: &u32| self.at(self.width - 1, *y) == Self::STRIP;
        let lines = bottoms.take_while(is_strip).map(|y| self.line(y));
        let mut lines: Vec<_> = lines.collect();
        lines.reverse();
        lines
    }

    /// The items of the open menu.
    #[must_use]
    pub fn menu(&self) -> Vec<String> {
        let is_open = self.at(0, 0) != Self::STRIP;
        let lines = (1..4).map(|line| self.line(line * Self::LINE));
        let items = lines.take_while(|line| is_open && !line.is_empty());
        items.collect()
    }

    /// The part below the menu bar.
    #[must_use]
    pub fn below_bar(&self) -> Self {
        let height = self.height - Self::LINE;
        Self::from_fn(self.width, height, |x, y| self.at(x, Self::LINE + y))
    }
}

impl From<&Image> for Picture {
    fn from(image: &Image) -> Self {
        let pixels = image.pixels().iter();
        Self {
            width: image.size().width(),
            height: image.size().height(),
            pixels: pixels.map(|color| Transfer::Linear.pack(*color)).collect(),
        }
    }
}

impl std::fmt::Debug for Picture {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "a picture of {}x{} pixels", self.width, self.height)
    }
}
