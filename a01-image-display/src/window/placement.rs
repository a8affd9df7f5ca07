//! `Placement`: position and scale of the picture in the window.

use std::ops::Range;

use common::Size;

use super::area::Area;

/// The largest factor by which a picture can be enlarged beyond the size that fits.
const GREATEST_FACTOR: f64 = 64.0;

/// A part of a pixel of the window that is smaller than this is not seen.
const UNSEEN: f64 = 1.0 / 256.0;

/// The columns of the picture in a column of the window, or its rows in a row.
#[derive(Clone, Debug, PartialEq)]
pub struct Footprint {
    /// None beside the picture.
    pub pixels: Range<u32>,
    /// The weight of the last one, where the others have 1.
    pub last: f64,
}

/// A picture in its part of the window.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Placement {
    pub area: Area,
    /// Width and height of the picture.
    sides: [f64; 2],
    /// Window pixels per picture pixel.
    pub scale: f64,
    /// Position of the picture's upper left corner, in whole pixels.
    corner: [f64; 2],
    /// Whether the scale does not follow from the size of the window.
    is_zoomed: bool,
}

impl Placement {
    /// Places a picture in a part of the window. One that is zoomed stays in its place.
    pub fn place(&mut self, picture: Size, area: Area) {
        self.area = area;
        self.sides = [picture.width(), picture.height()].map(f64::from);
        if !self.is_zoomed {
            self.fit();
        }
    }

    /// Places the picture in the middle, as large as fits.
    pub fn fit(&mut self) {
        self.scale = self.fitting_scale();
        let middle = self.area.middle();
        let half = self.sides.map(|side| self.scale * side / 2.0);
        self.corner = [0, 1].map(|axis| (middle[axis] - half[axis]).floor());
        self.is_zoomed = false;
    }

    /// The largest scale at which the picture fits.
    fn fitting_scale(&self) -> f64 {
        let [width, height] = [self.area.width, self.area.height].map(f64::from);
        (width / self.sides[0]).min(height / self.sides[1])
    }

    /// Zooms in to the next whole factor, or out, at most until the picture fits. The place
    /// under the cursor, if that is over the picture, stays there.
    pub fn zoom(&mut self, larger: bool, cursor: [i32; 2]) {
        let scale = if larger {
            (self.scale.floor() + 1.0).min(GREATEST_FACTOR)
        } else {
            self.scale.ceil() - 1.0
        };
        if scale <= self.fitting_scale() {
            return self.fit();
        }
        let under = cursor.map(|at| f64::from(at) + 0.5);
        let fixed = self.pixel(cursor).map_or(self.area.middle(), |_| under);
        let moved = |axis: usize| (self.corner[axis] - fixed[axis]) * scale / self.scale;
        self.corner = [0, 1].map(|axis| (fixed[axis] + moved(axis)).round());
        (self.scale, self.is_zoomed) = (scale, true);
    }

    /// Moves a zoomed picture by pixels of the window, at most until a side is in the middle.
    pub fn pan(&mut self, way: [i32; 2]) {
        let middle = self.area.middle().map(f64::floor);
        if self.is_zoomed {
            self.corner = [0, 1].map(|axis| {
                let least = middle[axis] - self.scale * self.sides[axis];
                (self.corner[axis] + f64::from(way[axis])).clamp(least, middle[axis])
            });
        }
    }

    /// The point of the window at a point of the picture.
    pub fn in_window(&self, point: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| self.corner[axis] + point[axis] * self.scale)
    }

    /// Column and row of the picture's pixel in the middle of a pixel of the window.
    pub fn pixel(&self, at: [i32; 2]) -> Option<[u32; 2]> {
        let place = |axis: usize| (f64::from(at[axis]) + 0.5 - self.corner[axis]) / self.scale;
        let is_inside = [0, 1].map(|axis| (0.0..self.sides[axis]).contains(&place(axis)));
        let is_inside = is_inside == [true; 2] && self.area.contains(at);
        is_inside.then(|| [0, 1].map(|axis| place(axis) as u32))
    }

    /// The columns of the picture in a column of the window, or its rows in a row, by the axis. Of an
    /// enlarged picture, a pixel of the window lies in one pixel or on the border of two, which it
    /// mixes by their parts of it; so all pixels look equally wide at every scale.
    pub fn footprint(&self, axis: usize, at: i32) -> Footprint {
        let [first, next] = [at, at + 1].map(|at| {
            let place = (f64::from(at) - self.corner[axis]) / self.scale;
            place.clamp(0.0, self.sides[axis])
        });
        if first >= next {
            return Footprint {
                pixels: 0..0,
                last: 1.0,
            };
        }
        let start = first as u32;
        let mut footprint = Footprint {
            pixels: start..(next as u32).max(start + 1),
            last: 1.0,
        };
        let border = next.floor();
        if self.scale > 1.0 && first < border {
            let part = (next - border) / (next - first);
            if part > 1.0 - UNSEEN {
                footprint.pixels = border as u32..border as u32 + 1;
            } else if part > UNSEEN {
                footprint.pixels = start..border as u32 + 1;
                footprint.last = part / (1.0 - part);
            }
        }
        footprint
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn placed(width: u32, height: u32) -> Placement {
        let mut placement = Placement::default();
        let size = Size::new(width, height).unwrap();
        placement.place(size, Area::new(0, 0, 640, 480));
        placement
    }

    /// At 2.5 times, every fifth column of the window lies on a border in the middle of it.
    #[test]
    fn an_enlarged_pixel_is_mixed_at_its_borders_only() {
        let placement = placed(256, 128);
        assert_eq!(placement.scale, 2.5);
        let columns = (0..5).map(|at| placement.footprint(0, at));
        let columns: Vec<_> = columns.map(|it| (it.pixels, it.last)).collect();
        let whole = |at| (at..at + 1, 1.0);
        assert_eq!(
            columns,
            [whole(0), whole(0), (0..2, 1.0), whole(1), whole(1)]
        );
        // At 3.2 times, a fifth of the fourth column lies in the first pixel.
        let column = placed(200, 3).footprint(0, 3);
        assert_eq!(column.pixels, 0..2);
        assert!((column.last - 4.0).abs() < 1e-12, "{column:?}");
    }

    /// A shrunk picture is first shown in its own size. One that fits enlarged by more than
    /// the greatest factor is not shrunk by zooming in.
    #[test]
    fn zooming_ends_where_the_picture_fits_and_at_64_times() {
        for (side, first, last) in [(100, 5.0, 64.0), (960, 1.0, 64.0), (1, 480.0, 480.0)] {
            let fitting = placed(side, side);
            let mut placement = fitting;
            placement.zoom(true, [-1; 2]);
            assert_eq!(placement.scale, first);
            placement.zoom(false, [-1; 2]);
            assert_eq!(placement, fitting);
            for _ in 0..100 {
                placement.zoom(true, [-1; 2]);
            }
            assert_eq!(placement.scale, last);
        }
    }
}
