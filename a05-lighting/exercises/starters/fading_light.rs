//! `FadingLight`: a lamp that is weaker the farther away it is.

use a02_math::{Direction, Point3};
use a05_lighting::{Illumination, Light};
use common::{ArgumentError, Color, argument};

/// A lamp at a point, with the colour that it has at the distance 1.
#[derive(Clone, Copy, Debug)]
pub struct FadingLight {
    color: Color,
    position: Point3,
}

impl FadingLight {
    /// The lamp that has this colour at the distance 1 from its position.
    pub fn new(color: Color, position: Point3) -> Result<Self, ArgumentError> {
        Ok(Self {
            color: argument::color("light colour", color)?,
            position: position.checked("light position")?,
        })
    }
}

impl Light for FadingLight {
    fn illumination(&self, point: Point3) -> Option<Illumination> {
        testing::missing("colour, direction and distance of the light", None)
    }
}
