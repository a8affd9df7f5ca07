//! `Lambert`: a matt surface, equally bright from every direction.
//!
//! Chapter: Light and material, section "Lambert". To compare afterwards:
//! `a05-lighting/src/lambert.rs`.

use a02_math::Direction;
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use a05_lighting::{Illumination, Lighting, Material};
use common::{ArgumentError, Color};

/// A matt material with this diffuse reflectance in each channel.
#[derive(Debug)]
pub struct Lambert {
    diffuse: Color,
}

impl Lambert {
    pub fn new(diffuse: Color) -> Result<Self, ArgumentError> {
        Ok(Self { diffuse })
    }
}

impl Material for Lambert {
    /// The light that is reflected from the hit back along the ray: of the ambient light
    /// and of each light that reaches the hit.
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        testing::missing("the reflected light", Color::BLACK)
    }
}
