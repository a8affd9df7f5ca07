//! `Reflective`: a shiny material that also mirrors.

use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use a05_lighting::{Lighting, Material, Phong};
use common::{ArgumentError, Color, argument};

use crate::Surface;

/// A Phong material with a mirror reflectance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reflective {
    pub(crate) shiny: Phong,
    pub(crate) reflection: Color,
}

impl Reflective {
    /// A [`Phong`] material with the mirror reflectance `reflection` in each
    /// channel, from 0 to 1: otherwise facing mirrors would amplify light.
    pub fn new(
        diffuse: Color,
        specular: Color,
        exponent: f64,
        reflection: Color,
    ) -> Result<Self, ArgumentError> {
        Ok(Self {
            shiny: Phong::new(diffuse, specular, exponent)?,
            reflection: argument::fraction("reflection", reflection)?,
        })
    }
}

/// The colour in the light of the lamps. The tracer adds the mirrored light, once
/// and after the sum over the lights.
impl Material for Reflective {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        self.shiny.color_for(ray, hit, lighting)
    }
}

impl Surface for Reflective {
    fn mirror_reflectance(&self) -> Color {
        self.reflection
    }
}
