//! `Placement`: where the picture stands in the window, and which of its pixels is seen where.

use common::Size;

use super::frame::Area;

/// A picture in the middle of its room, as large as fits.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Placement {
    /// Pixels of the window for a pixel of the picture.
    scale: f64,
    /// Width and height of the picture.
    sides: [u32; 2],
    /// Its upper left corner.
    corner: [i32; 2],
}

impl Placement {
    pub fn new(picture: Size, room: Area) -> Self {
        let sides = [picture.width(), picture.height()];
        let room_sides = [room.width, room.height].map(|side| f64::from(side.max(1)));
        let fit = |axis: usize| room_sides[axis] / f64::from(sides[axis]);
        let scale = fit(0).min(fit(1));
        let margin = |axis: usize| (room_sides[axis] - scale * f64::from(sides[axis])) as i32 / 2;
        Self {
            scale,
            sides,
            corner: [room.x + margin(0), room.y + margin(1)],
        }
    }

    /// The part of the window that the picture covers.
    pub fn area(&self) -> Area {
        let [width, height] = self
            .sides
            .map(|side| (self.scale * f64::from(side)).ceil() as i32);
        Area {
            x: self.corner[0],
            y: self.corner[1],
            width,
            height,
        }
    }

    /// The column or row of the picture, by the axis, at a part of a column or row of the window.
    pub fn inside(&self, axis: usize, at: i32, part: f64) -> u32 {
        let way = f64::from(at - self.corner[axis]) + part;
        ((way / self.scale) as u32).min(self.sides[axis].saturating_sub(1))
    }

    /// Column and row of the picture's pixel at a place of the window.
    pub fn pixel_at(&self, at: [i32; 2]) -> Option<[u32; 2]> {
        let is_inside = self.area().contains(at);
        is_inside.then(|| [0, 1].map(|axis| self.inside(axis, at[axis], 0.5)))
    }

    /// The point of the window at a point of the picture.
    pub fn in_window(&self, point: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| f64::from(self.corner[axis]) + self.scale * point[axis])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_is_as_large_as_fits() {
        let room = Area {
            x: 0,
            y: 30,
            width: 640,
            height: 480,
        };
        for (side, scale, first) in [
            (480, 1.0, 0),
            (200, 2.4, 0),
            // The middle of a pixel of the window is where four of the picture meet.
            (960, 0.5, 1),
        ] {
            let placement = Placement::new(Size::new(side, side).unwrap(), room);
            assert_eq!((placement.scale, placement.corner), (scale, [80, 30]));
            assert_eq!(placement.pixel_at([80, 30]), Some([first; 2]));
            assert_eq!(placement.pixel_at([559, 509]), Some([side - 1; 2]));
            assert_eq!(placement.pixel_at([560, 510]), None);
            assert_eq!(placement.pixel_at([79, 29]), None);
        }
    }
}
