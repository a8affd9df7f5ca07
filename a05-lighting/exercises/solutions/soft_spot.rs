//! `SoftSpot`: a spot light whose rim fades.

use a02_math::{Point3, Vector3};
use a05_lighting::{Illumination, Light, PointLight};
use common::{ArgumentError, Color, argument};

/// A light at a point that is full around one direction, and fades from there.
#[derive(Clone, Copy, Debug)]
pub struct SoftSpot {
    source: PointLight,
    direction: Vector3,
    inner: f64,
    outer: f64,
}

impl SoftSpot {
    /// A light that is full up to the angle `inner` from `direction`, and gone
    /// from the larger angle `outer` on, both in radians.
    pub fn new(
        color: Color,
        position: Point3,
        direction: Vector3,
        inner: f64,
        outer: f64,
    ) -> Result<Self, ArgumentError> {
        let inner = argument::not_negative("inner angle", inner)?;
        argument::check("outer angle", outer, outer > inner, "more than the inner")?;
        Ok(Self {
            source: PointLight::new(color, position)?,
            direction: direction.unit("light direction")?,
            inner,
            outer,
        })
    }
}

impl Light for SoftSpot {
    fn illumination(&self, point: Point3) -> Option<Illumination> {
        let light = self.source.illumination(point)?;
        // The light's direction leads to the lamp, the spot's direction away from it.
        let angle = (-light.direction).angle(self.direction);
        let x = ((self.outer - angle) / (self.outer - self.inner)).clamp(0.0, 1.0);
        let share = x * x * (3.0 - 2.0 * x);
        (share > 0.0).then(|| Illumination {
            color: light.color * share,
            ..light
        })
    }
}
