//! `Canvas`: lines, arrows and labels, for diagrams.
//!
//! A pixel takes as much of a shape's colour as the shape covers of it, which
//! is told by the distance from the pixel's middle to the shape's edge. Only
//! `+ - * /` and square roots are used, so that the bytes are the same on
//! every platform.

use std::ops::Range;

use common::{Color, Error, Image, Size};
use font8x8::legacy::{BASIC_LEGACY, GREEK_LEGACY, LATIN_LEGACY, MISC_LEGACY};

/// Width and height of a character in pixels, at scale 1.
const GLYPH: u32 = 8;

/// Length of an arrow's head, in widths of its line.
const HEAD_LENGTH: f64 = 6.0;

/// Half of the width of an arrow's head, in widths of its line.
const HEAD_HALF_WIDTH: f64 = 2.5;

/// Length in pixels of the shortest head whose corners can be told apart.
const SHORTEST_HEAD: f64 = 0.01;

/// Coordinates of at most this magnitude are drawn. From there the formulas
/// still find a pixel's distance to less than a hundredth.
const FARTHEST: f64 = 1e9;

/// A picture to draw on.
///
/// Points are (x, y) in pixels: x to the right, y down, (0, 0) being the top
/// left corner of the top left pixel and (0.5, 0.5) its middle. What lies
/// outside of the picture is cut off. A shape with a coordinate or a width that
/// is NaN or beyond 1e9 is not drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Canvas {
    image: Image,
}

impl Canvas {
    /// An empty picture.
    pub fn new(size: Size, background: Color) -> Result<Self, Error> {
        let mut image = Image::black(size)?;
        image.pixels_mut().fill(background);
        Ok(Self { image })
    }

    /// Draws a line of `width` pixels with round ends; where both ends are the
    /// same, a dot. Without a width above 0 there is none.
    pub fn line(&mut self, from: (f64, f64), to: (f64, f64), width: f64, color: Color) {
        let half = width / 2.0;
        if !(drawable(&[from, to, (width, width)]) && half > 0.0) {
            return;
        }
        // No pixel is covered by more than the line is wide.
        let most = width.min(1.0);
        self.blend(&[from, to], half + 0.5, color, |at| {
            (half + 0.5 - distance(at, from, to)).clamp(0.0, most)
        });
    }

    /// Draws a line of `width` pixels that ends in a filled head with its tip
    /// at `to`. The head is no longer than the arrow; where both ends are the
    /// same there is no direction to point in, and a dot instead.
    pub fn arrow(&mut self, from: (f64, f64), to: (f64, f64), width: f64, color: Color) {
        let (x, y) = (to.0 - from.0, to.1 - from.1);
        let length = (x * x + y * y).sqrt();
        let head = (HEAD_LENGTH * width).min(length);
        if !(drawable(&[from, to, (width, width)]) && head >= SHORTEST_HEAD) {
            self.line(from, to, width, color);
            return;
        }
        let (x, y) = (x / length, y / length);
        let base = (to.0 - head * x, to.1 - head * y);
        if head < length {
            self.line(from, base, width, color);
        }
        let side = head * HEAD_HALF_WIDTH / HEAD_LENGTH;
        let left = (base.0 + side * y, base.1 - side * x);
        let right = (base.0 - side * y, base.1 + side * x);
        self.triangle([to, right, left], color);
    }

    /// Fills a triangle of three different corners that follow one another
    /// clockwise.
    fn triangle(&mut self, [a, b, c]: [(f64, f64); 3], color: Color) {
        // Beyond a sharp corner the edges' distances are still small.
        self.blend(&[a, b, c], 1.5, color, |at| {
            let outside = [(a, b), (b, c), (c, a)].map(|(from, to)| left_of(at, from, to));
            let farthest = outside.into_iter().fold(f64::NEG_INFINITY, f64::max);
            (0.5 - farthest).clamp(0.0, 1.0)
        });
    }

    /// Writes `text` in one row, `at` being its top left corner, moved to the
    /// nearest pixel; every dot of a letter is `scale` pixels wide and high.
    ///
    /// There are the characters of ASCII, Latin-1 and Greek, and a few signs
    /// such as ≤ and ≥. Any other shows as a question mark.
    pub fn text(&mut self, at: (f64, f64), scale: u32, color: Color, text: &str) {
        if !drawable(&[at]) {
            return;
        }
        let scale = f64::from(scale);
        let (mut left, top) = (at.0.round(), at.1.round());
        for character in text.chars() {
            for (row, bits) in (0_u8..).zip(glyph(character)) {
                for column in (0_u8..8).filter(|column| bits >> column & 1 == 1) {
                    let x = left + scale * f64::from(column);
                    let y = top + scale * f64::from(row);
                    let corners = [(x, y), (x + scale, y + scale)];
                    self.blend(&corners, 0.0, color, |_| 1.0);
                }
            }
            left += scale * f64::from(GLYPH);
        }
    }

    /// Width and height of a text in pixels.
    #[must_use]
    pub fn text_size(scale: u32, text: &str) -> (f64, f64) {
        let side = f64::from(scale) * f64::from(GLYPH);
        (side * text.chars().count() as f64, side)
    }

    /// The finished picture.
    #[must_use]
    pub fn into_image(self) -> Image {
        self.image
    }

    /// Lays `color` over the pixels in the box around `points`, enlarged by
    /// `margin`: as much of it as `coverage` says, from 0 to 1, for the
    /// pixel's middle.
    fn blend(
        &mut self,
        points: &[(f64, f64)],
        margin: f64,
        color: Color,
        coverage: impl Fn((f64, f64)) -> f64,
    ) {
        let size = self.image.size();
        let columns = covered(points.iter().map(|point| point.0), margin, size.width());
        let rows = covered(points.iter().map(|point| point.1), margin, size.height());
        for y in rows {
            for x in columns.clone() {
                let share = coverage((f64::from(x) + 0.5, f64::from(y) + 0.5));
                if share > 0.0
                    && let Some(below) = self.image.get(x, y)
                {
                    self.image.set(x, y, below * (1.0 - share) + color * share);
                }
            }
        }
    }
}

/// The pixels of a side of the picture that lie between the coordinates.
fn covered(coordinates: impl Iterator<Item = f64> + Clone, margin: f64, side: u32) -> Range<u32> {
    let least = coordinates.clone().fold(f64::INFINITY, f64::min) - margin;
    let most = coordinates.fold(f64::NEG_INFINITY, f64::max) + margin;
    // The casts saturate: what is left of the picture begins at 0.
    let [first, end] = [least.floor(), most.ceil()].map(|at| (at as u32).min(side));
    first..end
}

fn drawable(points: &[(f64, f64)]) -> bool {
    let near = |coordinate: f64| coordinate.abs() <= FARTHEST;
    points.iter().all(|(x, y)| near(*x) && near(*y))
}

/// The distance of a point from the line between two others.
fn distance(at: (f64, f64), from: (f64, f64), to: (f64, f64)) -> f64 {
    let (line_x, line_y) = (to.0 - from.0, to.1 - from.1);
    let (x, y) = (at.0 - from.0, at.1 - from.1);
    let square = line_x * line_x + line_y * line_y;
    // How far along the line the nearest point lies, from 0 to 1.
    let along = if square > 0.0 {
        ((x * line_x + y * line_y) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    let (x, y) = (x - along * line_x, y - along * line_y);
    (x * x + y * y).sqrt()
}

/// How far a point lies to the left of a line without ends, as seen on the
/// screen by who walks along it; negative to the right.
fn left_of(at: (f64, f64), from: (f64, f64), to: (f64, f64)) -> f64 {
    let (line_x, line_y) = (to.0 - from.0, to.1 - from.1);
    let (x, y) = (at.0 - from.0, at.1 - from.1);
    (line_y * x - line_x * y) / (line_x * line_x + line_y * line_y).sqrt()
}

/// Eight rows from the top, the lowest bit being the leftmost dot.
pub(crate) fn glyph(character: char) -> [u8; 8] {
    let code = character as usize;
    match character {
        ' '..='~' => BASIC_LEGACY[code],
        '\u{a0}'..='\u{ff}' => LATIN_LEGACY[code - 0xa0],
        // Between rho and sigma one code point is not assigned.
        '\u{390}'..='\u{3a1}' | '\u{3a3}'..='\u{3c9}' => GREEK_LEGACY[code - 0x390],
        '≤' => MISC_LEGACY[5],
        '≥' => MISC_LEGACY[6],
        // Minus and the dot operator look like their cousins in Latin-1.
        '−' => glyph('-'),
        '⋅' => glyph('·'),
        _ => glyph('?'),
    }
}

#[cfg(test)]
mod tests;
