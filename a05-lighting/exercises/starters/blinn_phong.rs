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
            color += testing::missing("matt light and highlight", self.diffuse * cosine);
        });
        color
    }
}
