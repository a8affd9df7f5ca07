//! `PointLight`: shines from one point in all directions.

use a02_math::{Point3, Vector3x4};
use a03_rays_cameras::Focus;
use common::{ArgumentError, Color, argument};

use crate::light::one_by_one;
use crate::{ColorPacket, Illumination, IlluminationPacket, Light};

/// A light at a point. It does not grow weaker with distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight {
    color: Color,
    position: Point3,
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
        let way = self.position - point;
        Some(Illumination {
            color: self.color,
            direction: way.normalized()?,
            distance: way.magnitude(),
        })
    }
    // ANCHOR_END: illumination

    fn illuminations(&self, points: Vector3x4, active: u32) -> IlluminationPacket {
        let way = Vector3x4::splat(self.position.to_glam()) - points;
        let (direction, is_unit) = way.normalized();
        if active & !is_unit.to_bitmask() != 0 {
            return one_by_one(self, points, active);
        }
        IlluminationPacket {
            lit: active,
            color: ColorPacket::splat(self.color),
            direction,
            distance: way.dot(way).sqrt(),
        }
    }

    fn brightest(&self) -> Color {
        self.color.map(f64::abs)
    }

    fn focus(&self) -> Option<Focus> {
        Some(Focus::Point(self.position))
    }
}
