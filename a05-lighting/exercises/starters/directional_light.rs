//! `DirectionalLight`: shines from infinitely far away, like the sun.
//!
//! Chapter: Light and material, section "Three lights". To compare afterwards:
//! `a05-lighting/src/directional_light.rs`.

use a02_math::{Point3, Vector3};
use a05_lighting::{Illumination, Light};
use common::{ArgumentError, Color};

/// A light with the same direction everywhere.
#[derive(Debug)]
pub struct DirectionalLight {
    color: Color,
    /// The direction in which the light travels, of length 1.
    direction: Vector3,
}

impl DirectionalLight {
    pub fn new(color: Color, direction: Vector3) -> Result<Self, ArgumentError> {
        Ok(Self {
            color,
            direction: direction.unit("light direction")?,
        })
    }
}

impl Light for DirectionalLight {
    /// The light that arrives at `point`: its colour, the direction of length 1 from the
    /// point to the light, and the distance.
    fn illumination(&self, point: Point3) -> Option<Illumination> {
        testing::missing("the light that arrives", None)
    }
}
