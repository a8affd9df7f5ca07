//! `PointLight`: shines from one point in all directions.

use a02_math::Point3;
use common::{ArgumentError, Color, argument};

use crate::{Illumination, Light};

/// A light at a point. It does not grow weaker with distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight {
    pub(crate) color: Color,
    pub(crate) position: Point3,
}

impl PointLight {
    /// A light of this colour at this position.
    pub fn new(color: Color, position: Point3) -> Result<Self, ArgumentError> {
        Ok(Self {
            color: argument::color("light colour", color)?,
            position: position.checked("light position")?,
        })
    }
}

impl Light for PointLight {
    // ANCHOR: illumination
    fn illumination(&self, point: Point3) -> Option<Illumination> {
        let to_light = self.position - point;
        Some(Illumination {
            color: self.color,
            direction: to_light.normalized()?,
            distance: to_light.magnitude(),
        })
    }
    // ANCHOR_END: illumination
}
