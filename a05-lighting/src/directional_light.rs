//! `DirectionalLight`: shines from infinitely far away, like the sun.

use a02_math::{Point3, Vector3};
use common::{ArgumentError, Color, argument};

use crate::{Illumination, Light};

/// A light with the same direction everywhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DirectionalLight {
    pub(crate) color: Color,
    pub(crate) direction: Vector3,
}

impl DirectionalLight {
    /// A light that travels in `direction`, which has any length but 0.
    pub fn new(color: Color, direction: Vector3) -> Result<Self, ArgumentError> {
        Ok(Self {
            color: argument::color("light colour", color)?,
            direction: direction.unit("light direction")?,
        })
    }
}

impl Light for DirectionalLight {
    // ANCHOR: illumination
    fn illumination(&self, _: Point3) -> Option<Illumination> {
        Some(Illumination {
            color: self.color,
            direction: -self.direction,
            distance: f64::INFINITY,
        })
    }
    // ANCHOR_END: illumination
}
