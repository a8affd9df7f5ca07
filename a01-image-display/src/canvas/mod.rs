//! `Canvas`: lines, arrows and labels, for diagrams.
//!
//! The colour of a shape is blended in proportion to its coverage of the pixel,
//! which follows from the distance between the pixel's middle and the edge. Only
//! `+ - * /` and square roots are used, so that the bytes are the same on
//! every platform.

pub mod font;

use std::ops::Range;

use common::{Color, Error, Image, Size};

use font::dots;

/// Length of an arrow's head, in widths of its line.
const HEAD_LENGTH: f64 = 6.0;

/// Half of the width of an arrow's head, in widths of its line.
const HEAD_HALF_WIDTH: f64 = 2.5;

/// Length in pixels of the shortest head with visibly different corners.
const MIN_HEAD: f64 = 0.01;

/// Largest magnitude of a coordinate that is drawn. There a pixel's distance is
/// still computed with an error below a hundredth.
const MAX_COORDINATE: f64 = 1e9;

/// A picture to draw on.
///
/// Points are (x, y) in pixels: x to the right, y down, (0, 0) being the top
/// left corner of the top left pixel and (0.5, 0.5) its middle. Shapes are
/// clipped at the borders of the picture. A shape with a coordinate or a width that
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

    /// Draws a line of `width` pixels with round ends; a dot if both ends are the
    /// same. A width of 0 or less draws nothing.
    pub fn line(&mut self, from: (f64, f64), to: (f64, f64), width: f64, color: Color) {
        let half = width / 2.0;
        if !(drawable(&[from, to, (width, width)]) && half > 0.0) {
            return;
        }
        // A line narrower than a pixel covers no more of it than its width.
        let most = width.min(1.0);
        self.blend(&[from, to], half + 0.5, color, |at| {
            (half + 0.5 - distance(at, from, to)).clamp(0.0, most)
        });
    }

    /// Draws a line of `width` pixels that ends in a filled head with its tip
    /// at `to`. The head is no longer than the arrow. If both ends are the same,
    /// the arrow has no direction and is drawn as a dot.
    pub fn arrow(&mut self, from: (f64, f64), to: (f64, f64), width: f64, color: Color) {
        let (x, y) = (to.0 - from.0, to.1 - from.1);
        let length = (x * x + y * y).sqrt();
        let head = (HEAD_LENGTH * width).min(length);
        if !(drawable(&[from, to, (width, width)]) && head >= MIN_HEAD) {
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
        // The margin clips beyond a sharp corner, where all distances are small.
        self.blend(&[a, b, c], 1.5, color, |at| {
            let outside = [(a, b), (b, c), (c, a)].map(|(from, to)| left_of(at, from, to));
            let farthest = outside.into_iter().fold(f64::NEG_INFINITY, f64::max);
            (0.5 - farthest).clamp(0.0, 1.0)
        });
    }

    /// Writes `text` in one row. Its top left corner is `at`, rounded to the
    /// nearest pixel; every dot of a letter is `scale` pixels wide and high. Only the
    /// characters of ASCII and Latin-1 are known.
    pub fn text(&mut self, at: (f64, f64), scale: u32, color: Color, text: &str) {
        if !drawable(&[at]) {
            return;
        }
        let scale = f64::from(scale);
        for (column, row) in dots(text) {
            let x = at.0.round() + scale * f64::from(column);
            let y = at.1.round() + scale * f64::from(row);
            self.blend(&[(x, y), (x + scale, y + scale)], 0.0, color, |_| 1.0);
        }
    }

    /// The finished picture.
    #[must_use]
    pub fn into_image(self) -> Image {
        self.image
    }

    /// Blends `color` over the pixels in the box around `points`, enlarged by
    /// `margin`. The weight of `color` is `coverage` at the pixel's middle, from
    /// 0 to 1.
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
                let fraction = coverage((f64::from(x) + 0.5, f64::from(y) + 0.5));
                if fraction > 0.0
                    && let Some(below) = self.image.get(x, y)
                {
                    self.image
                        .set(x, y, below * (1.0 - fraction) + color * fraction);
                }
            }
        }
    }
}

/// Range of the pixels of a row or column that lie between the coordinates.
fn covered(coordinates: impl Iterator<Item = f64> + Clone, margin: f64, side: u32) -> Range<u32> {
    let least = coordinates.clone().fold(f64::INFINITY, f64::min) - margin;
    let most = coordinates.fold(f64::NEG_INFINITY, f64::max) + margin;
    // The casts saturate: a negative coordinate becomes 0.
    let [first, end] = [least.floor(), most.ceil()].map(|at| (at as u32).min(side));
    first..end
}

fn drawable(points: &[(f64, f64)]) -> bool {
    let near = |coordinate: f64| coordinate.abs() <= MAX_COORDINATE;
    points.iter().all(|(x, y)| near(*x) && near(*y))
}

/// The distance of a point from the line between two others.
pub fn distance(at: (f64, f64), from: (f64, f64), to: (f64, f64)) -> f64 {
    let (line_x, line_y) = (to.0 - from.0, to.1 - from.1);
    let (x, y) = (at.0 - from.0, at.1 - from.1);
    let square = line_x * line_x + line_y * line_y;
    // Position of the nearest point along the line, from 0 to 1.
    let along = if square > 0.0 {
        ((x * line_x + y * line_y) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    let (x, y) = (x - along * line_x, y - along * line_y);
    (x * x + y * y).sqrt()
}

/// Signed distance of a point from an infinite line, in pixels: positive to the
/// left of its direction as seen on the screen, negative to the right.
fn left_of(at: (f64, f64), from: (f64, f64), to: (f64, f64)) -> f64 {
    let (line_x, line_y) = (to.0 - from.0, to.1 - from.1);
    let (x, y) = (at.0 - from.0, at.1 - from.1);
    (line_y * x - line_x * y) / (line_x * line_x + line_y * line_y).sqrt()
}

#[cfg(test)]
mod tests;
