//! `Frame`: the pixels of the window.

use crate::canvas::distance;

/// A part of the window, in pixels from its upper left corner.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Area {
    pub x: i32,
    pub y: i32,
    pub width: i32,
    pub height: i32,
}

impl Area {
    pub const fn new(x: i32, y: i32, width: i32, height: i32) -> Self {
        #[rustfmt::skip]
        let area = Self { x, y, width, height };
        area
    }

    /// Whether a place lies inside.
    pub const fn contains(self, (x, y): (i32, i32)) -> bool {
        self.x <= x && x < self.x + self.width && self.y <= y && y < self.y + self.height
    }

    /// This area without borders of some pixels.
    pub const fn inset(self, x: i32, y: i32) -> Self {
        Self::new(
            self.x + x,
            self.y + y,
            self.width - 2 * x,
            self.height - 2 * y,
        )
    }

    /// The part that lies inside of another area.
    fn inside(self, other: Self) -> Self {
        let (x, y) = (self.x.max(other.x), self.y.max(other.y));
        let right = (self.x + self.width).min(other.x + other.width);
        let bottom = (self.y + self.height).min(other.y + other.height);
        let is_empty = right <= x || bottom <= y;
        if is_empty {
            Self::default()
        } else {
            Self::new(x, y, right - x, bottom - y)
        }
    }
}

/// Packed 0xRRGGBB pixels, row after row from the top. Drawing is clipped.
#[derive(Default)]
pub struct Frame {
    width: usize,
    clip: Area,
    pub pixels: Vec<u32>,
}

impl Frame {
    /// Takes the size of the window.
    pub fn resize(&mut self, (width, height): (usize, usize)) {
        self.width = width;
        self.pixels.resize(width * height, 0);
    }

    /// Limits the following drawing to an area inside of the window.
    pub fn clip(&mut self, area: Area) {
        let height = self.pixels.len() / self.width.max(1);
        self.clip = area.inside(Area::new(0, 0, self.width as i32, height as i32));
    }

    /// The rows of an area, from the top: the place of each in the window, and its pixels.
    pub fn rows(&mut self, area: Area) -> impl Iterator<Item = ((i32, i32), &mut [u32])> {
        let Area {
            x,
            y,
            width,
            height,
        } = area.inside(self.clip);
        let rows = self.pixels.chunks_exact_mut(self.width.max(1));
        let rows = (0..).zip(rows).skip(y as usize).take(height as usize);
        rows.map(move |(y, row)| ((x, y), &mut row[x as usize..][..width as usize]))
    }

    /// Fills an area with one colour.
    pub fn fill(&mut self, area: Area, color: u32) {
        self.rows(area).for_each(|(_, row)| row.fill(color));
    }

    /// Blends a colour over an area, by a share from 0 to 1 for each pixel.
    pub fn blend(&mut self, area: Area, color: u32, share: impl Fn(i32, i32) -> f64) {
        for ((left, y), row) in self.rows(area) {
            for (x, pixel) in (left..).zip(row) {
                let share = (256.0 * share(x, y)) as u32;
                // Red and blue have room for their products beside each other.
                let mix = |mask: u32| {
                    let [below, above] = [*pixel, color].map(|color| u64::from(color & mask));
                    let sum = below * u64::from(256 - share) + above * u64::from(share);
                    (sum >> 8) as u32 & mask
                };
                *pixel = mix(0xFF_00FF) | mix(0x00_FF00);
            }
        }
    }

    /// Draws a line with round ends, by a share of its colour; a dot if both ends are the same.
    pub fn line(&mut self, ends: [(f64, f64); 2], width: f64, color: u32, share: f64) {
        let [from, to] = ends;
        let (left, right) = (from.0.min(to.0) - width, from.0.max(to.0) + width);
        let (top, bottom) = (from.1.min(to.1) - width, from.1.max(to.1) + width);
        let [x, y, right, bottom] = [left, top, right + 1.0, bottom + 1.0].map(|at| at as i32);
        self.blend(Area::new(x, y, right - x, bottom - y), color, |x, y| {
            let at = (f64::from(x) + 0.5, f64::from(y) + 0.5);
            (width / 2.0 + 0.5 - distance(at, from, to)).clamp(0.0, 1.0) * share
        });
    }
}
