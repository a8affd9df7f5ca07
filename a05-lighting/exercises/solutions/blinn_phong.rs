//! `BlinnPhong`: a highlight by the vector half way between light and eye.

use a02_math::Direction;
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use a05_lighting::{Lighting, Material};
use common::{ArgumentError, Color, argument};

/// A shiny material: `Σ (cd cl max(0, n · l) + cs cl max(0, n · h)^p)`.
#[derive(Clone, Copy, Debug)]
pub struct BlinnPhong {
    diffuse: Color,
    specular: Color,
    exponent: f64,
}

impl BlinnPhong {
    /// The material that scatters `diffuse` and mirrors `specular` of each light.
    pub fn new(diffuse: Color, specular: Color, exponent: f64) -> Result<Self, ArgumentError> {
        Ok(Self {
            diffuse: argument::color("diffuse", diffuse)?,
            specular: argument::color("specular", specular)?,
            exponent: argument::not_negative("exponent", exponent)?,
        })
    }
}

impl Material for BlinnPhong {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        let mut color = self.diffuse * lighting.ambient();
        lighting.for_each_light(ray, hit, &mut |light| {
            let cosine = hit.normal.dot(light.direction);
            // Light from behind is neither scattered nor mirrored.
            if cosine <= 0.0 {
                return;
            }
            color += self.diffuse * light.color * cosine;
            // Opposite directions have no half way.
            let Some(half) = (light.direction - ray.direction()).normalized() else {
                return;
            };
            let highlight = hit.normal.dot(half).clamp(0.0, 1.0);
            color += self.specular * light.color * libm::pow(highlight, self.exponent);
        });
        color
    }
}
