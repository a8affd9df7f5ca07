//! `SpotLight`: shines from one point into a cone.

use std::f64::consts::PI;

use a02_math::{Direction, Point3, Vector3};
use common::{ArgumentError, Color, argument};

use crate::{Illumination, Light, PointLight};

/// A light at a point that shines into a cone of directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpotLight {
    pub(crate) source: PointLight,
    pub(crate) direction: Vector3,
    pub(crate) cos_half_angle: f64,
}

impl SpotLight {
    /// A light whose cone has the axis `direction`, of any length but 0. The edge
    /// of the cone, at `half_angle` from the axis, is lit.
    ///
    /// The half angle, in radians, is from 1e-7 to π; the cosine of a smaller
    /// angle rounds to 1.
    pub fn new(
        color: Color,
        position: Point3,
        direction: Vector3,
        half_angle: f64,
    ) -> Result<Self, ArgumentError> {
        let valid = (1e-7..=PI).contains(&half_angle);
        let allowed = "an angle in radians from 1e-7 to pi";
        argument::check("half angle", half_angle, valid, allowed)?;
        Ok(Self {
            source: PointLight::new(color, position)?,
            direction: direction.unit("light direction")?,
            cos_half_angle: libm::cos(half_angle),
        })
    }
}

/// Compares cosines, not angles: rounding can make the dot product greater than
/// 1, whose arc cosine is NaN, and the arc cosine merges different small angles.
impl Light for SpotLight {
    // ANCHOR: illumination
    fn illumination(&self, point: Point3) -> Option<Illumination> {
        let light = self.source.illumination(point)?;
        // The product of two opposite unit vectors may be a little less than -1.
        let cosine = (-light.direction).dot(self.direction).max(-1.0);
        (cosine >= self.cos_half_angle).then_some(light)
    }
    // ANCHOR_END: illumination
}
