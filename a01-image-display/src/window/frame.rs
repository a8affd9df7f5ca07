//! `Frame`: the pixels of the window.

use crate::canvas::glyph;

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
    /// A line of text below the row `y`, from the left edge of the window.
    pub const fn line(y: i32, width: i32) -> Self {
        Self {
            x: 0,
            y,
            width,
            height: LINE,
        }
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
        for (column, letter) in (0..).zip(text.chars()) {
            let rows = glyph(letter);
            let area = Area {
                x: x + column * LETTER,
                y,
                width: LETTER,
                height: LETTER,
            };
            self.paint(area, |at_x, at_y| {
                let (row, dot) = ((at_y - area.y) as usize, at_x - area.x);
                (rows[row] >> dot & 1 == 1).then_some(color)
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const AREA: Area = Area {
        x: 2,
        y: 1,
        width: 3,
        height: 2,
    };

    fn frame(width: usize, height: usize) -> Frame {
        let mut frame = Frame::default();
        frame.clear((width, height), 1);
        frame
    }

    #[test]
    fn an_area_is_filled_and_cut_off_at_the_borders() {
        let mut frame = frame(6, 4);
        frame.fill(AREA, 7);
        let rows = [[1; 6], [1, 1, 7, 7, 7, 1], [1, 1, 7, 7, 7, 1], [1; 6]];
        assert_eq!(frame.pixels(), rows.concat());

        for (x, y, column, row) in [(-2, -1, 0, 0), (5, 3, 5, 3)] {
            frame.clear((6, 4), 1);
            frame.fill(Area { x, y, ..AREA }, 7);
            let mut expected = [1; 24];
            expected[row * 6 + column] = 7;
            assert_eq!(frame.pixels(), expected);
        }
    }

    #[test]
    fn a_place_without_a_colour_keeps_its_own() {
        let mut frame = frame(2, 2);
        let all = Area { x: 0, y: 0, ..AREA };
        frame.paint(all, |x, y| (x == 1).then_some(10 + y as u32));
        assert_eq!(frame.pixels(), [1, 10, 1, 11]);
    }

    #[test]
    fn letters_follow_one_another_dot_by_dot() {
        let mut frame = frame(24, 12);
        frame.text(3, 2, 7, "gR");
        for (index, pixel) in frame.pixels().iter().enumerate() {
            let (x, y) = (index % 24, index / 24);
            let is_dot = (2..10).contains(&y) && (3..19).contains(&x) && {
                let letter = if x < 11 { 'g' } else { 'R' };
                glyph(letter)[y - 2] >> ((x - 3) % 8) & 1 == 1
            };
            assert_eq!(*pixel, if is_dot { 7 } else { 1 }, "{x} {y}");
        }
    }
}
