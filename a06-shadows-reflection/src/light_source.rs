//! `LightSource`: a light that may cast shadows.

use a02_math::Point3;
use a05_lighting::{Illumination, Light};

/// A light, and whether objects cast shadows in it.
#[derive(Debug)]
pub struct LightSource {
    pub(crate) light: Box<dyn Light>,
    pub(crate) casts_shadows: bool,
}

impl LightSource {
    /// A source of this light. If it casts shadows, objects between it and a
    /// surface block it.
    pub fn new(light: impl Light, casts_shadows: bool) -> Self {
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
}
