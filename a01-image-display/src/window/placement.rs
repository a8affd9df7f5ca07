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

    const WINDOW: Area = Area {
        x: 0,
        y: 18,
        width: 640,
        height: 480,
    };

    fn placed(width: u32, height: u32, zoom: Zoom) -> Placement {
        Placement::new(Size::new(width, height).unwrap(), WINDOW, zoom)
    }

    /// 640 / 100 = 6.4 and 480 / 100 = 4.8: four times, with borders. A picture of twice
    /// the width is shrunk by half.
    #[test]
    fn a_picture_is_as_large_as_fits_in_the_middle() {
        let enlarged = Zoom::Factor(2, (320.0, 240.0));
        for (size, zoom, x, y, expected) in [
            ((640, 480), Zoom::Fit, 0, 0, Some((0, 0))),
            ((640, 480), Zoom::Fit, 123, 45, Some((123, 45))),
            ((640, 480), Zoom::Fit, 639, 479, Some((639, 479))),
            ((640, 480), Zoom::Fit, 640, 0, None),
            ((100, 100), Zoom::Fit, 120, 40, Some((0, 0))),
            ((100, 100), Zoom::Fit, 119, 40, None),
            ((100, 100), Zoom::Fit, 123, 43, Some((0, 0))),
            ((100, 100), Zoom::Fit, 124, 44, Some((1, 1))),
            ((100, 100), Zoom::Fit, 519, 439, Some((99, 99))),
            ((100, 100), Zoom::Fit, 520, 439, None),
            ((1280, 480), Zoom::Fit, 0, 119, None),
            ((1280, 480), Zoom::Fit, 0, 120, Some((1, 1))),
            ((1280, 480), Zoom::Fit, 639, 359, Some((1279, 479))),
            ((1280, 480), Zoom::Fit, 639, 360, None),
            // Never outside of its part of the window, below 18 rows for the menu.
            ((640, 480), enlarged, 0, 0, Some((160, 120))),
            ((640, 480), enlarged, 639, 479, Some((479, 359))),
            ((640, 480), enlarged, 0, -1, None),
            ((640, 480), enlarged, -1, 0, None),
            ((640, 480), enlarged, 640, 0, None),
            ((640, 480), enlarged, 0, 480, None),
        ] {
            let pixel = placed(size.0, size.1, zoom).pixel(x, y + 18);
            assert_eq!(pixel, expected, "{size:?} {x} {y}");
        }
    }

    #[test]
    fn zooming_keeps_the_pixel_under_the_cursor() {
        let cursor = (500, 100);
        let mut placement = placed(640, 480, Zoom::Fit);
        let under = placement.pixel(cursor.0, cursor.1);
        for _ in 0..5 {
            let zoom = placement.zoomed_in(Some(cursor));
            placement = placed(640, 480, zoom);
            assert_eq!(placement.pixel(cursor.0, cursor.1), under);
        }
        assert!(matches!(placement.zoomed_in(None), Zoom::Factor(7, _)));
    }

    #[test]
    fn zooming_out_ends_where_the_picture_fits() {
        let mut zoom = placed(100, 100, Zoom::Fit).zoomed_in(None);
        assert!(matches!(zoom, Zoom::Factor(5, _)), "{zoom:?}");
        zoom = placed(100, 100, zoom).zoomed_out(None);
        assert_eq!(zoom, Zoom::Fit);
        assert_eq!(placed(100, 100, zoom).zoomed_out(None), Zoom::Fit);
        // A shrunk picture: first its own size, then enlarged.
        let zoom = placed(1280, 960, Zoom::Fit).zoomed_in(None);
        assert!(matches!(zoom, Zoom::Factor(1, _)), "{zoom:?}");
        assert_eq!(placed(1280, 960, zoom).zoomed_out(None), Zoom::Fit);
    }

    #[test]
    fn zooming_in_ends_and_never_shrinks() {
        let zoom = placed(1, 1, Zoom::Fit).zoomed_in(None);
        assert!(matches!(zoom, Zoom::Factor(480, _)), "{zoom:?}");
        let zoom_in = |zoom, _| placed(640, 480, zoom).zoomed_in(None);
        let zoom = (0..100).fold(Zoom::Fit, zoom_in);
        assert!(matches!(zoom, Zoom::Factor(GREATEST_FACTOR, _)), "{zoom:?}");
    }

    /// The middle of the window is (350, 258), the middle of the picture (320, 240).
    #[test]
    fn zooming_without_a_cursor_keeps_the_middle() {
        let area = Area { x: 30, ..WINDOW };
        let picture = Size::new(640, 480).unwrap();
        let fit = Placement::new(picture, area, Zoom::Fit);
        let middle = (320.0, 240.0);
        assert_eq!(fit.zoomed_in(None), Zoom::Factor(2, middle));
        let beside = Some((5, 100));
        assert_eq!(fit.zoomed_in(beside), Zoom::Factor(2, middle));
        let third = Placement::new(picture, area, Zoom::Factor(3, middle));
        assert_eq!(third.zoomed_out(None), Zoom::Factor(2, middle));
        assert_eq!(third.pixel(350, 258), Some((320, 240)));
        assert_eq!(third.pixel(347, 255), Some((319, 239)));
    }

    /// The middle of pixel (500, 100) lies (180.5, -157.5) from the middle of the window:
    /// a third of that in the picture that is three times as large, and a quarter in
    /// the next.
    #[test]
    fn zooming_moves_the_middle_towards_the_cursor() {
        let third = placed(640, 480, Zoom::Factor(3, (320.0, 240.0)));
        let (to_x, to_y) = (320.0 + 180.5 / 3.0, 240.0 - 157.5 / 3.0);
        let Zoom::Factor(4, (x, y)) = third.zoomed_in(Some((500, 100))) else {
            panic!("four times as large");
        };
        let (middle_x, middle_y) = (to_x - 180.5 / 4.0, to_y + 157.5 / 4.0);
        assert!((x - middle_x).abs() < 1e-9 && (y - middle_y).abs() < 1e-9);
    }
}
