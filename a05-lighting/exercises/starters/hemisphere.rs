//! `Hemisphere`: a matt material between a bright sky and a dark ground.

use a02_math::{Direction, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use a05_lighting::{Lighting, Material};
use common::{ArgumentError, Color, argument};

/// A matt material lit by the whole sky and by the whole ground, and by no lamp.
#[derive(Clone, Copy, Debug)]
pub struct Hemisphere {
    diffuse: Color,
    sky: Color,
    ground: Color,
}

impl Hemisphere {
    /// The material that scatters `diffuse` of the light of sky and ground.
    pub fn new(diffuse: Color, sky: Color, ground: Color) -> Result<Self, ArgumentError> {
        Ok(Self {
            diffuse: argument::color("diffuse", diffuse)?,
            sky: argument::color("sky", sky)?,
            ground: argument::color("ground", ground)?,
        })
    }
}

impl Material for Hemisphere {
    fn color_for(&self, _: &Ray, hit: &Hit, _: &dyn Lighting) -> Color {
        let up = Vector3::new(0.0, 1.0, 0.0);
        testing::missing("the light of sky and ground", self.diffuse * self.sky)
    }
}
