//! `SpotLight`: shines from one point into a cone.
//!
//! Chapter: Light and material, section "Three lights". To compare afterwards:
//! `a05-lighting/src/spot_light.rs`.

use a02_math::{Direction, Point3, Vector3};
use a05_lighting::{Illumination, Light, PointLight};
use common::{ArgumentError, Color};

/// A light at a point that shines into a cone of directions.
#[derive(Debug)]
pub struct SpotLight {
    source: PointLight,
    /// The axis of the cone, away from the light, of length 1.
    direction: Vector3,
    /// The angle in radians between the axis and the edge of the cone, up to π.
    half_angle: f64,
}

impl SpotLight {
    pub fn new(
        color: Color,
        position: Point3,
        direction: Vector3,
        half_angle: f64,
    ) -> Result<Self, ArgumentError> {
        Ok(Self {
            source: PointLight::new(color, position)?,
            direction: direction.unit("light direction")?,
            half_angle,
        })
    }
}

impl Light for SpotLight {
    /// The light that arrives at `point`, the light of the source if the point lies in
    /// the cone, and none otherwise.
    ///
    /// `libm::cos(x)` is a cosine.
    fn illumination(&self, point: Point3) -> Option<Illumination> {
        let light = self.source.illumination(point)?;
        testing::missing("whether the point lies in the cone", None)
    }
}
