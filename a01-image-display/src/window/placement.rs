//! `Placement`: position and scale of the picture in the window.

use common::Size;

use super::area::Area;

/// The scale of the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Zoom {
    /// As large as fits: enlarged by a whole factor, which keeps pixels sharp, or shrunk.
    Fit,
    /// Enlarged by a whole factor, this place of the picture in the middle.
    Factor(f64, [f64; 2]),
}

/// A picture in its part of the window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Window pixels per picture pixel.
    pub scale: f64,
    /// The scale at which the picture fits.
    fit: f64,
    /// Position of the picture's upper left corner.
    corner: [f64; 2],
    /// Width and height of the picture.
    sides: [f64; 2],
    pub area: Area,
}

/// The largest factor by which a picture can be enlarged beyond the size that fits.
const GREATEST_FACTOR: f64 = 64.0;

/// Most places of the picture, along a side, whose mean is a pixel of the window.
const MOST_PLACES: f64 = 4.0;

impl Placement {
    /// The place of a picture in this part of the window.
    pub fn new(picture: Size, area: Area, zoom: Zoom) -> Self {
        let sides = [picture.width(), picture.height()].map(f64::from);
        let fit = (f64::from(area.width) / sides[0]).min(f64::from(area.height) / sides[1]);
        let fit = if fit >= 1.0 { fit.floor() } else { fit };
        let (scale, middle) = match zoom {
            Zoom::Fit => (fit, sides.map(|side| side / 2.0)),
            Zoom::Factor(factor, middle) => (factor, middle),
        };
        let center = area.middle();
        Self {
            scale,
            fit,
            // Whole coordinates, so that at scale 1 the pixels coincide.
            corner: [0, 1].map(|axis| (center[axis] - middle[axis] * scale).floor()),
            sides,
            area,
        }
    }

    /// The point of the window at a point of the picture.
    pub fn in_window(&self, point: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| self.corner[axis] + point[axis] * self.scale)
    }

    /// The point of the picture at a point of the window.
    fn in_picture(&self, point: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| (point[axis] - self.corner[axis]) / self.scale)
    }

    /// Column and row of the picture's pixel in the middle of a pixel of the window.
    pub fn pixel(&self, at: [i32; 2]) -> Option<[u32; 2]> {
        let [x, y] = self.in_picture(at.map(|at| f64::from(at) + 0.5));
        let is_inside = (0.0..self.sides[0]).contains(&x) && (0.0..self.sides[1]).contains(&y);
        (is_inside && self.area.contains(at)).then_some([x as u32, y as u32])
    }

    /// The columns of the picture in a column of the window, or its rows in a row, by the axis;
    /// none beside the picture.
    pub fn spread(&self, axis: usize, at: i32) -> Vec<u32> {
        let places = (1.0 / self.scale).ceil().clamp(1.0, MOST_PLACES);
        let at = f64::from(at) - self.corner[axis];
        let places = (0..places as u32).map(|i| (at + (f64::from(i) + 0.5) / places) / self.scale);
        let inside = places.filter(|place| (0.0..self.sides[axis]).contains(place));
        inside.map(|place| place as u32).collect()
    }

    /// Zoomed in to the next whole factor, or out, at most until it fits. The place under the
    /// cursor, if that is over the picture, stays there.
    pub fn zoomed(&self, larger: bool, cursor: [i32; 2]) -> Zoom {
        let factor = if larger {
            // A picture of few pixels may fit enlarged by more than the greatest factor.
            (self.scale.floor() + 1.0).min(GREATEST_FACTOR.max(self.fit))
        } else {
            self.scale.ceil() - 1.0
        };
        if !larger && factor <= self.fit {
            return Zoom::Fit;
        }
        let middle = self.in_picture(self.area.middle());
        let under = self.in_picture(cursor.map(|at| f64::from(at) + 0.5));
        let fixed = self.pixel(cursor).map_or(middle, |_| under);
        // The place under the cursor stays there if the middle moves towards it.
        let share = self.scale / factor;
        let moved = [0, 1].map(|axis| fixed[axis] + (middle[axis] - fixed[axis]) * share);
        Zoom::Factor(factor, moved)
    }

    /// Moved by pixels of the window, if it is zoomed.
    pub fn panned(&self, zoom: Zoom, way: [i32; 2]) -> Zoom {
        let Zoom::Factor(factor, middle) = zoom else {
            return zoom;
        };
        let moved = |axis: usize| middle[axis] - f64::from(way[axis]) / factor;
        Zoom::Factor(
            factor,
            [0, 1].map(|axis| moved(axis).clamp(0.0, self.sides[axis])),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A shrunk picture is first shown in its own size. One that fits enlarged by more than
    /// the greatest factor is not shrunk by zooming in.
    #[test]
    fn zooming_ends_where_the_picture_fits_and_at_64_times() {
        for (side, first, last) in [(100, 5.0, 64.0), (960, 1.0, 64.0), (1, 480.0, 480.0)] {
            let size = Size::new(side, side).unwrap();
            let placed = |zoom| Placement::new(size, Area::new(0, 18, 640, 480), zoom);
            let zoom_in = |zoom, _| placed(zoom).zoomed(true, [0; 2]);
            let middle = [f64::from(side) / 2.0; 2];
            let first_zoom = zoom_in(Zoom::Fit, 0);
            assert_eq!(first_zoom, Zoom::Factor(first, middle));
            let last_zoom = (0..100).fold(Zoom::Fit, zoom_in);
            assert_eq!(last_zoom, Zoom::Factor(last, middle));
            assert_eq!(placed(first_zoom).zoomed(false, [0; 2]), Zoom::Fit);
        }
    }
}
