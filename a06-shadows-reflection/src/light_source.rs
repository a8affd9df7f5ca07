//! `LightSource`: a light that may cast shadows.

use a02_math::{Point3, Vector3x4};
use a03_rays_cameras::Focus;
use a05_lighting::{Illumination, IlluminationPacket, Light};
use common::Color;

/// A light, and whether objects cast shadows in it.
#[derive(Debug)]
pub struct LightSource {
    light: Box<dyn Light>,
    casts_shadows: bool,
}

impl LightSource {
    /// A light that what is in its way keeps away, or that nothing does.
    pub fn new(light: impl Light + 'static, casts_shadows: bool) -> Self {
        Self {
            light: Box::new(light),
            casts_shadows,
        }
    }

    /// Whether objects cast shadows in this light.
    #[must_use]
    pub const fn casts_shadows(&self) -> bool {
        self.casts_shadows
    }
}

impl Light for LightSource {
    fn illumination(&self, point: Point3) -> Option<Illumination> {
        self.light.illumination(point)
    }

    fn illuminations(&self, points: Vector3x4, active: u32) -> IlluminationPacket {
        self.light.illuminations(points, active)
    }

    fn brightest(&self) -> Color {
        self.light.brightest()
    }

    fn focus(&self) -> Option<Focus> {
        self.light.focus()
    }
}
