//! `Lambert`: a matt surface, equally bright from every direction.

use a02_math::Direction;
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use common::{ArgumentError, Color, argument};

use crate::{Illumination, Lighting, Material};

/// A matt material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lambert {
    pub(crate) diffuse: Color,
}

impl Lambert {
    /// The material with this diffuse reflectance in each channel.
    pub fn new(diffuse: Color) -> Result<Self, ArgumentError> {
        let diffuse = argument::color("diffuse", diffuse)?;
        Ok(Self { diffuse })
    }

    /// The contribution of one light: `cd cl max(0, n · l)`. Light at a grazing
    /// angle is spread over a larger area.
    // ANCHOR: diffuse-term
    pub(crate) fn diffuse_term(&self, hit: &Hit, light: &Illumination) -> Color {
        self.diffuse * light.color * hit.normal.dot(light.direction).max(0.0)
    }
    // ANCHOR_END: diffuse-term

    /// The contribution of the ambient light, `cd ca`.
    pub(crate) fn ambient(&self, lighting: &dyn Lighting) -> Color {
        self.diffuse * lighting.ambient()
    }
}

/// `c = cd ca + Σ cd cl max(0, n · l)`, with the sum over all lights.
impl Material for Lambert {
    // ANCHOR: color
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        let mut color = self.ambient(lighting);
        lighting.for_each_light(ray, hit, &mut |light| {
            color += self.diffuse_term(hit, light);
        });
        color
    }
    // ANCHOR_END: color
}
