//! `Frame`: the pixels of the window, and what is drawn with them.

use crate::canvas::distance;
use crate::canvas::font::dots;

/// A rectangle of the window, in pixels from its upper left corner.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Area {
    pub x: i32,
    pub y: i32,
    pub width: i32,
    pub height: i32,
}

impl Area {
    pub const fn contains(&self, [x, y]: [i32; 2]) -> bool {
        x >= self.x && x < self.x + self.width && y >= self.y && y < self.y + self.height
    }
}

/// Packed 0xRRGGBB pixels, row after row from the top.
#[derive(Default)]
pub struct Frame {
    width: usize,
    pub pixels: Vec<u32>,
}

impl Frame {
    /// A frame of one colour.
    pub fn new(width: usize, height: usize, color: u32) -> Self {
        let pixels = vec![color; width * height];
        Self { width, pixels }
    }

    /// The part inside of the window of each row of an area, and where it begins.
    pub fn rows(&mut self, area: Area) -> impl Iterator<Item = ([i32; 2], &mut [u32])> {
        let [left, right] = [area.x, area.x + area.width].map(|x| x.clamp(0, self.width as i32));
        let rows = self.pixels.chunks_exact_mut(self.width.max(1));
        let rows = (0..).zip(rows).skip(area.y.max(0) as usize);
        rows.take_while(move |(y, _)| *y < area.y + area.height)
            .map(move |(y, row)| ([left, y], &mut row[left as usize..right.max(left) as usize]))
    }

    /// Fills an area.
    pub fn fill(&mut self, area: Area, color: u32) {
        for (_, row) in self.rows(area) {
            row.fill(color);
        }
    }

    /// Draws a line with round ends; a dot if both ends are the same.
    pub fn line(&mut self, [from, to]: [[f64; 2]; 2], width: f64, color: u32) {
        // A line may lead far out of the window.
        let [from, to] = [from, to].map(|end| end.map(|at| at.clamp(-1e6, 1e6)));
        let around = Area {
            x: (from[0].min(to[0]) - width) as i32,
            y: (from[1].min(to[1]) - width) as i32,
            width: ((from[0] - to[0]).abs() + 2.0 * width + 2.0) as i32,
            height: ((from[1] - to[1]).abs() + 2.0 * width + 2.0) as i32,
        };
        for ([left, y], row) in self.rows(around) {
            for (x, pixel) in (left..).zip(row) {
                let middle = (f64::from(x) + 0.5, f64::from(y) + 0.5);
                let away = distance(middle, from.into(), to.into());
                let covered = (width / 2.0 + 0.5 - away).clamp(0.0, 1.0);
                *pixel = mixed(*pixel, color, covered);
            }
        }
    }

    /// Writes a text from its upper left corner; each dot of a letter is `dot` pixels wide, and twice
    /// as high.
    pub fn text(&mut self, [x, y]: [i32; 2], dot: i32, color: u32, text: &str) {
        for (column, row) in dots(text) {
            let rectangle = Area {
                x: x + dot * column as i32,
                y: y + 2 * dot * row as i32,
                width: dot,
                height: 2 * dot,
            };
            self.fill(rectangle, color);
        }
    }
}

/// A colour between two, by the fraction of the second one from 0 to 1.
fn mixed(below: u32, above: u32, fraction: f64) -> u32 {
    let fraction = (256.0 * fraction) as u32;
    let channel = |shift: u32| {
        let [below, above] = [below, above].map(|color| color >> shift & 0xFF);
        ((below * (256 - fraction) + above * fraction) / 256) << shift
    };
    channel(16) | channel(8) | channel(0)
}

/// The lines of a text of at most this many letters, broken at spaces where there are some.
pub fn wrapped(text: &str, most: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split(' ') {
        let mut letters = word.chars().peekable();
        while letters.peek().is_some() {
            let part: String = letters.by_ref().take(most.max(1)).collect();
            let used = lines.last().map_or(0, |line| line.chars().count());
            let has_room = used + 1 + part.chars().count() <= most;
            match lines.last_mut() {
                Some(line) if line.is_empty() => line.push_str(&part),
                Some(line) if has_room => {
                    line.push(' ');
                    line.push_str(&part);
                }
                _ => lines.push(part),
            }
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn drawings_end_at_the_window() {
        let mut frame = Frame::new(4, 3, 7);
        let corner = Area {
            x: -2,
            y: 1,
            width: 4,
            height: 9,
        };
        frame.fill(corner, 5);
        assert_eq!(frame.pixels, [7, 7, 7, 7, 5, 5, 7, 7, 5, 5, 7, 7]);
        frame.line([[-9.0, -9.0], [-9.0, 99.0]], 2.0, 1);
        frame.line([[3.5, 0.5], [3.5, 0.5]], 1.0, 9);
        frame.text([2, 1], 1, 1, "I");
        assert_eq!(frame.pixels[..4], [7, 7, 7, 9]);
        Frame::new(0, 0, 0).fill(corner, 1);
    }

    #[test]
    fn lines_break_at_spaces_or_in_long_words() {
        assert_eq!(wrapped("one two three", 7), ["one two", "three"]);
        assert_eq!(wrapped("a longword", 4), ["a", "long", "word"]);
        assert_eq!(wrapped("", 4), [""]);
    }
}
