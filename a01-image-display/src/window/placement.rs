//! `Placement`: position and scale of the picture in the window.

use common::Size;

use super::frame::Area;

/// The scale of the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Zoom {
    /// As large as fits: enlarged by a whole factor, or shrunk.
    #[default]
    Fit,
    /// Enlarged by a whole factor, this place of the picture in the middle.
    Factor(u32, (f64, f64)),
}

/// A picture in its part of the window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Window pixels per picture pixel.
    scale: f64,
    /// Position of the picture's upper left corner.
    corner: (f64, f64),
    picture: Size,
    area: Area,
}

/// The largest factor by which a picture can be enlarged beyond the size that fits.
const GREATEST_FACTOR: u32 = 64;

impl Placement {
    /// The place of a picture in this part of the window.
    pub fn new(picture: Size, area: Area, zoom: Zoom) -> Self {
        let [width, height] = [picture.width(), picture.height()].map(f64::from);
        let (scale, middle) = match zoom {
            Zoom::Fit => {
                let fit = (f64::from(area.width) / width).min(f64::from(area.height) / height);
                // Whole factors keep pixels crisp.
                let scale = if fit >= 1.0 { fit.floor() } else { fit };
                (scale, (width / 2.0, height / 2.0))
            }
            Zoom::Factor(factor, middle) => (factor.into(), middle),
        };
        // Whole coordinates, so that at scale 1 the pixels coincide.
        let corner = |start: i32, side: i32, middle: f64| {
            (f64::from(start) + f64::from(side) / 2.0 - middle * scale).floor()
        };
        Self {
            scale,
            corner: (
                corner(area.x, area.width, middle.0),
                corner(area.y, area.height, middle.1),
            ),
            picture,
            area,
        }
    }

    /// The part of the window that is left for the picture.
    pub const fn area(&self) -> Area {
        self.area
    }

    /// The point of the picture at a point of the window.
    fn place(&self, (x, y): (f64, f64)) -> (f64, f64) {
        let (left, top) = self.corner;
        ((x - left) / self.scale, (y - top) / self.scale)
    }

    /// Column and row of the picture's pixel that is shown at a pixel of the
    /// window, if there is one.
    pub fn pixel(&self, x: i32, y: i32) -> Option<(u32, u32)> {
        let (column, row) = self.place(middle_of(x, y));
        let inside = self.area.contains(x, y)
            && (0.0..self.picture.width().into()).contains(&column)
            && (0.0..self.picture.height().into()).contains(&row);
        inside.then_some((column as u32, row as u32))
    }

    /// Enlarged by the next whole factor; the pixel under the cursor, if the cursor is
    /// over the picture, stays in place.
    pub fn zoomed_in(&self, cursor: Option<(i32, i32)>) -> Zoom {
        let factor = self.scale.floor() as u32;
        // A picture of few pixels may fit enlarged by more than that.
        let factor = (factor + 1).min(GREATEST_FACTOR.max(factor));
        self.zoomed(factor, cursor)
    }

    /// Shrunk to the next smaller whole factor; as large as fits if that is larger.
    pub fn zoomed_out(&self, cursor: Option<(i32, i32)>) -> Zoom {
        let factor = (self.scale.ceil() as u32).saturating_sub(1);
        let fit = Self::new(self.picture, self.area, Zoom::Fit);
        if f64::from(factor) > fit.scale {
            self.zoomed(factor, cursor)
        } else {
            Zoom::Fit
        }
    }

    fn zoomed(&self, factor: u32, cursor: Option<(i32, i32)>) -> Zoom {
        let (x, y) = self.place((
            f64::from(self.area.x) + f64::from(self.area.width) / 2.0,
            f64::from(self.area.y) + f64::from(self.area.height) / 2.0,
        ));
        let over = cursor.filter(|(x, y)| self.pixel(*x, *y).is_some());
        let (to_x, to_y) = over.map_or((x, y), |(x, y)| self.place(middle_of(x, y)));
        // The point under the cursor stays there if the middle moves towards it.
        let share = self.scale / f64::from(factor);
        let middle = (to_x + (x - to_x) * share, to_y + (y - to_y) * share);
        Zoom::Factor(factor, middle)
    }
}

/// The middle of a pixel of the window.
fn middle_of(x: i32, y: i32) -> (f64, f64) {
    (f64::from(x) + 0.5, f64::from(y) + 0.5)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn placed(width: u32, height: u32, zoom: Zoom) -> Placement {
        let area = Area::new(0, 18, 640, 480);
        Placement::new(Size::new(width, height).unwrap(), area, zoom)
    }

    #[test]
    fn zooming_keeps_the_pixel_under_the_cursor_or_the_middle() {
        // Beside the picture, the cursor does not count.
        for (cursor, (x, y)) in [((500, 100), (500, 100)), ((5, 5), (320, 258))] {
            let mut placement = placed(640, 480, Zoom::Fit);
            let under = placement.pixel(x, y);
            for factor in 2..7 {
                let zoom = placement.zoomed_in(Some(cursor));
                assert!(matches!(zoom, Zoom::Factor(found, _) if found == factor));
                placement = placed(640, 480, zoom);
                assert_eq!(placement.pixel(x, y), under);
            }
        }
    }

    /// A shrunk picture is first shown in its own size. One that fits enlarged by more than
    /// the greatest factor is not shrunk by zooming in.
    #[test]
    fn zooming_ends_where_the_picture_fits_and_at_64_times() {
        for (side, first, last) in [(100, 5, 64), (960, 1, 64), (1, 480, 480)] {
            let zoom_in = |zoom, _| placed(side, side, zoom).zoomed_in(None);
            let first_zoom = zoom_in(Zoom::Fit, 0);
            let last_zoom = (0..100).fold(Zoom::Fit, zoom_in);
            let middle = (f64::from(side) / 2.0, f64::from(side) / 2.0);
            assert_eq!(first_zoom, Zoom::Factor(first, middle));
            assert_eq!(last_zoom, Zoom::Factor(last, middle));
            assert_eq!(placed(side, side, first_zoom).zoomed_out(None), Zoom::Fit);
        }
    }
}
