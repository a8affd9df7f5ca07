//! `Placement`: position and scale of the picture in the window.

use common::Size;

use super::frame::Area;

/// The scale of the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Zoom {
    /// As large as fits: enlarged by a whole factor, which keeps pixels sharp, or shrunk.
    Fit,
    /// Enlarged by a whole factor, this place of the picture in the middle.
    Factor(u32, (f64, f64)),
}

/// A picture in its part of the window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Window pixels per picture pixel.
    pub scale: f64,
    /// Position of the picture's upper left corner.
    corner: (f64, f64),
    pub picture: Size,
    pub area: Area,
}

/// The largest factor by which a picture can be enlarged beyond the size that fits.
const GREATEST_FACTOR: u32 = 64;

impl Placement {
    /// The place of a picture in this part of the window.
    pub fn new(picture: Size, area: Area, zoom: Zoom) -> Self {
        let [width, height] = [picture.width(), picture.height()].map(f64::from);
        let fit = (f64::from(area.width) / width).min(f64::from(area.height) / height);
        let (scale, middle) = match zoom {
            Zoom::Fit if fit >= 1.0 => (fit.floor(), (width / 2.0, height / 2.0)),
            Zoom::Fit => (fit, (width / 2.0, height / 2.0)),
            Zoom::Factor(factor, middle) => (factor.into(), middle),
        };
        // Whole coordinates, so that at scale 1 the pixels coincide.
        let corner = |start: i32, side: i32, middle: f64| {
            (f64::from(start) + f64::from(side) / 2.0 - middle * scale).floor()
        };
        let x = corner(area.x, area.width, middle.0);
        let y = corner(area.y, area.height, middle.1);
        Self {
            scale,
            corner: (x, y),
            picture,
            area,
        }
    }

    /// The point of the window at a point of the picture.
    pub fn in_window(&self, [x, y]: [f64; 2]) -> (f64, f64) {
        let (left, top) = self.corner;
        (left + x * self.scale, top + y * self.scale)
    }

    /// Column and row of the picture's pixel that is shown at a pixel of the window.
    pub fn pixel(&self, (x, y): (i32, i32)) -> Option<(u32, u32)> {
        let (column, row) = (self.columns(x, 1).next()??, self.rows(y, 1).next()??);
        self.area.contains((x, y)).then_some((column, row))
    }

    /// The columns of the picture at some places in a pixel of the window; none beside the
    /// picture.
    pub fn columns(&self, x: i32, places: u32) -> impl Iterator<Item = Option<u32>> {
        spread(x, places, self.corner.0, self.scale, self.picture.width())
    }

    /// The rows of the picture, likewise.
    pub fn rows(&self, y: i32, places: u32) -> impl Iterator<Item = Option<u32>> {
        spread(y, places, self.corner.1, self.scale, self.picture.height())
    }

    /// Zoomed in to the next whole factor, or out, at most until it fits. The place under the
    /// cursor, if that is over the picture, stays there.
    pub fn zoomed(&self, larger: bool, cursor: (i32, i32)) -> Zoom {
        let fit = Self::new(self.picture, self.area, Zoom::Fit).scale;
        let factor = if larger {
            let factor = self.scale.floor() as u32;
            // A picture of few pixels may fit enlarged by more than that.
            (factor + 1).min(GREATEST_FACTOR.max(factor))
        } else {
            (self.scale.ceil() as u32).saturating_sub(1)
        };
        if f64::from(factor) <= fit && !larger {
            return Zoom::Fit;
        }
        let area = self.area;
        let half = |start: i32, side: i32| f64::from(start) + f64::from(side) / 2.0;
        let middle = self.place(half(area.x, area.width), half(area.y, area.height));
        let under = || self.place(f64::from(cursor.0) + 0.5, f64::from(cursor.1) + 0.5);
        let to = self.pixel(cursor).map_or(middle, |_| under());
        // The place under the cursor stays there if the middle moves towards it.
        let share = self.scale / f64::from(factor);
        let moved = |to: f64, from: f64| to + (from - to) * share;
        Zoom::Factor(factor, (moved(to.0, middle.0), moved(to.1, middle.1)))
    }

    /// Moved by pixels of the window, if it is zoomed.
    pub fn panned(&self, zoom: Zoom, (x, y): (i32, i32)) -> Zoom {
        let Zoom::Factor(factor, (across, down)) = zoom else {
            return zoom;
        };
        let moved = |middle: f64, way: i32, side: u32| {
            (middle - f64::from(way) / self.scale).clamp(0.0, f64::from(side))
        };
        let across = moved(across, x, self.picture.width());
        Zoom::Factor(factor, (across, moved(down, y, self.picture.height())))
    }

    /// The point of the picture at a point of the window.
    fn place(&self, x: f64, y: f64) -> (f64, f64) {
        (
            (x - self.corner.0) / self.scale,
            (y - self.corner.1) / self.scale,
        )
    }
}

/// Columns, or rows, of a picture at places that are evenly spread over a pixel of the window.
fn spread(
    at: i32,
    places: u32,
    start: f64,
    scale: f64,
    side: u32,
) -> impl Iterator<Item = Option<u32>> {
    (0..places).map(move |i| {
        let at = f64::from(at) + (f64::from(i) + 0.5) / f64::from(places);
        let place = (at - start) / scale;
        (0.0..side.into()).contains(&place).then_some(place as u32)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A shrunk picture is first shown in its own size. One that fits enlarged by more than
    /// the greatest factor is not shrunk by zooming in.
    #[test]
    fn zooming_ends_where_the_picture_fits_and_at_64_times() {
        for (side, first, last) in [(100, 5, 64), (960, 1, 64), (1, 480, 480)] {
            let size = Size::new(side, side).unwrap();
            let placed = |zoom| Placement::new(size, Area::new(0, 18, 640, 480), zoom);
            let zoom_in = |zoom, _| placed(zoom).zoomed(true, (0, 0));
            let middle = (f64::from(side) / 2.0, f64::from(side) / 2.0);
            let first_zoom = zoom_in(Zoom::Fit, 0);
            assert_eq!(first_zoom, Zoom::Factor(first, middle));
            let last_zoom = (0..100).fold(Zoom::Fit, zoom_in);
            assert_eq!(last_zoom, Zoom::Factor(last, middle));
            assert_eq!(placed(first_zoom).zoomed(false, (0, 0)), Zoom::Fit);
        }
    }
}
