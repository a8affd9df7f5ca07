//! `PointLight`: shines from one point in all directions.
//!
//! Chapter: Light and material, section "Three lights". To compare afterwards:
//! `a05-lighting/src/point_light.rs`.

use a02_math::Point3;
use a05_lighting::{Illumination, Light};
use common::{ArgumentError, Color};

/// A light at a point. It does not grow weaker with distance.
#[derive(Debug)]
pub struct PointLight {
    color: Color,
    position: Point3,
}

impl PointLight {
    pub fn new(color: Color, position: Point3) -> Result<Self, ArgumentError> {
        Ok(Self { color, position })
    }
}

impl Light for PointLight {
    /// The light that arrives at `point`: its colour, the direction of length 1 from the
    /// point to the light, and the distance. None in the light itself.
    fn illumination(&self, point: Point3) -> Option<Illumination> {
        testing::missing("the light that arrives", None)
    }
}
