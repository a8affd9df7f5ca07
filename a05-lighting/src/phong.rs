//! `Phong`: a matt surface with highlights, where it mirrors a light.

use a02_math::Direction;
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use common::{ArgumentError, Color, argument};

use crate::power::power;
use crate::{Illumination, Lambert, Lighting, Material};

/// A shiny material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phong {
    pub(crate) matt: Lambert,
    pub(crate) specular: Color,
    pub(crate) exponent: f64,
}

impl Phong {
    /// The material with the reflectances `diffuse` and `specular` in each
    /// channel. The higher the exponent, which is at least 0,
    /// the smaller and sharper the highlight.
    pub fn new(diffuse: Color, specular: Color, exponent: f64) -> Result<Self, ArgumentError> {
        Ok(Self {
            matt: Lambert::new(diffuse)?,
            specular: argument::color("specular", specular)?,
            exponent: argument::not_negative("exponent", exponent)?,
        })
    }

    /// The highlight of one light, `cs cl max(0, e · r)^p`, with `e` to the eye
    /// and `r` the direction in which the surface mirrors the light.
    // ANCHOR: highlight
    fn highlight(&self, ray: &Ray, hit: &Hit, light: &Illumination) -> Color {
        let (e, l) = (-ray.direction(), light.direction);
        let cosine = e.dot(l.reflected_on(hit.normal));
        // Light from behind is not mirrored. Without this return, 0 to the power
        // of 0 would be a highlight.
        let is_mirrored = hit.normal.dot(l) > 0.0 && cosine > 0.0;
        if !is_mirrored || self.specular == Color::BLACK {
            return Color::BLACK;
        }
        // The power of a cosine of 1 + 2^-52 could grow to millions.
        self.specular * light.color * power(cosine.min(1.0), self.exponent)
    }
    // ANCHOR_END: highlight
}

/// `c = cd ca + Σ (cd cl max(0, n · l) + cs cl max(0, e · r)^p)`, with the sum
/// over all lights. (Phong, Illumination for Computer Generated Pictures, 1975)
impl Material for Phong {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        let mut color = self.matt.ambient(lighting);
        // A black surface, such as a pure mirror, asks for no light.
        if self.matt.diffuse == Color::BLACK && self.specular == Color::BLACK {
            return color;
        }
        lighting.for_each_light(ray, hit, &mut |light| {
            color += self.matt.diffuse_term(hit, light) + self.highlight(ray, hit, light);
        });
        color
    }
}
