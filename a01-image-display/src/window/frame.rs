//! `Frame`: the pixels of the window.

use super::area::Area;
use crate::canvas::distance;

/// Packed 0xRRGGBB pixels, row after row from the top.
#[derive(Default)]
pub struct Frame {
    width: usize,
    /// The part of the window that drawing changes.
    pub clip: Area,
    pub pixels: Vec<u32>,
}

impl Frame {
    /// Takes the size of the window.
    pub fn resize(&mut self, width: usize, height: usize) {
        self.width = width;
        self.clip = Area::new(0, 0, width as i32, height as i32);
        self.pixels.resize(width * height, 0);
    }

    /// The rows of an area, from the top: the place of each in the window, and its pixels.
    pub fn rows(&mut self, area: Area) -> impl Iterator<Item = ((i32, i32), &mut [u32])> {
        let inside = |start: i32, side: i32, [first, sides]: [i32; 2]| {
            let ends = [start, start + side.max(0)];
            ends.map(|end| end.clamp(first, first + sides) as usize)
        };
        let [left, right] = inside(area.x, area.width, [self.clip.x, self.clip.width]);
        let [top, bottom] = inside(area.y, area.height, [self.clip.y, self.clip.height]);
        let rows = self.pixels.chunks_exact_mut(self.width.max(1));
        let rows = (0..).zip(rows).take(bottom).skip(top);
        rows.map(move |(y, row)| ((left as i32, y), &mut row[left..right]))
    }

    /// Fills an area with one colour.
    pub fn fill(&mut self, area: Area, color: u32) {
        self.rows(area).for_each(|(_, row)| row.fill(color));
    }

    /// Blends a colour over an area, by a fraction from 0 to 1 for each pixel.
    pub fn blend(&mut self, area: Area, color: u32, fraction: impl Fn(i32, i32) -> f64) {
        for ((left, y), row) in self.rows(area) {
            for (x, pixel) in (left..).zip(row) {
                let fraction = (256.0 * fraction(x, y)) as u32;
                // Red and blue have room for their products beside each other.
                let mix = |mask: u32| {
                    let [below, above] = [*pixel, color].map(|color| u64::from(color & mask));
                    let sum = below * u64::from(256 - fraction) + above * u64::from(fraction);
                    (sum >> 8) as u32 & mask
                };
                *pixel = mix(0xFF_00FF) | mix(0x00_FF00);
            }
        }
    }

    /// Draws a line with round ends, by a fraction of its colour; a dot if both ends are the same.
    pub fn line(&mut self, [from, to]: [[f64; 2]; 2], width: f64, color: u32, fraction: f64) {
        let [x, y] = [0, 1].map(|axis| (from[axis].min(to[axis]) - width) as i32);
        let [right, bottom] = [0, 1].map(|axis| (from[axis].max(to[axis]) + width + 1.0) as i32);
        self.blend(Area::new(x, y, right - x, bottom - y), color, |x, y| {
            let at = (f64::from(x) + 0.5, f64::from(y) + 0.5);
            let away = distance(at, from.into(), to.into());
            (width / 2.0 + 0.5 - away).clamp(0.0, 1.0) * fraction
        });
    }
}
