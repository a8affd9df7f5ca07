//! `Area`: a rectangle of the window.

/// Position and size in pixels, from the upper left corner of the window.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
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
    pub const fn contains(self, [x, y]: [i32; 2]) -> bool {
        self.x <= x && x < self.x + self.width && self.y <= y && y < self.y + self.height
    }

    /// The point in the middle.
    pub fn middle(self) -> [f64; 2] {
        [(self.x, self.width), (self.y, self.height)]
            .map(|(start, side)| f64::from(start) + f64::from(side) / 2.0)
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
}
