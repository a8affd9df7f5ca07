//! `DirectionalLight`: shines from infinitely far away, like the sun.

use a02_math::{Lanes, Point3, Vector3, Vector3x4};
use a03_rays_cameras::Focus;
use common::{ArgumentError, Color, argument};

use crate::{ColorPacket, Illumination, IlluminationPacket, Light};

/// A light that shines everywhere in the same direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DirectionalLight {
    color: Color,
    direction: Vector3,
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

    fn illuminations(&self, _: Vector3x4, active: u32) -> IlluminationPacket {
        IlluminationPacket {
            lit: active,
            color: ColorPacket::splat(self.color),
            direction: Vector3x4::splat(-self.direction.to_glam()),
            distance: Lanes::splat(f64::INFINITY),
        }
    }

    fn brightest(&self) -> Color {
        self.color.map(f64::abs)
    }

    fn focus(&self) -> Option<Focus> {
        Some(Focus::Direction(self.direction))
    }
}
