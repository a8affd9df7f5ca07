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
        let way = self.position - point;
        Some(Illumination {
            // The same light falls on a sphere of the area 4 π d².
            color: self.color * (1.0 / way.dot(way)),
            direction: way.normalized()?,
            distance: way.magnitude(),
        })
    }
}
