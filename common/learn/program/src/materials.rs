//! Materials by your functions.

use crate::prelude::*;

/// A matt material.
#[derive(Debug)]
pub struct Lambert {
    pub diffuse: Color,
}

impl Material for Lambert {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        lambert(self.diffuse, ray, hit, lighting)
    }
}

impl Surface for Lambert {}

/// A material with highlights, which also mirrors.
#[derive(Debug)]
pub struct Reflective {
    pub diffuse: Color,
    pub specular: Color,
    pub exponent: f64,
    /// The mirror reflectance in each channel, from 0 to 1.
    pub reflection: Color,
}

impl Material for Reflective {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        let colors = [self.diffuse, self.specular];
        phong(colors, self.exponent, ray, hit, lighting)
    }
}

impl Surface for Reflective {
    fn mirror_reflectance(&self) -> Color {
        self.reflection
    }
}
