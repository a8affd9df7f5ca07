//! `Phong`: a matt surface with highlights, where it mirrors a light.
//!
//! Chapter: Light and material, section "Phong". To compare afterwards:
//! `a05-lighting/src/phong.rs`.

use a02_math::Direction;
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use a05_lighting::{Illumination, Lambert, Lighting, Material};
use common::{ArgumentError, Color};

/// A shiny material.
#[derive(Debug)]
pub struct Phong {
    diffuse: Color,
    specular: Color,
    exponent: f64,
}

impl Phong {
    pub fn new(diffuse: Color, specular: Color, exponent: f64) -> Result<Self, ArgumentError> {
        Ok(Self {
            diffuse,
            specular,
            exponent,
        })
    }
}

impl Material for Phong {
    /// The light that is reflected from the hit back along the ray: of the ambient light
    /// and, matt and as a highlight, of each light that reaches the hit.
    ///
    /// `l.reflected_on(n)` is a direction mirrored by a surface, and `libm::pow(x, y)` a
    /// power.
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        testing::missing("the reflected light", Color::BLACK)
    }
}
