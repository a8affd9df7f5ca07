//! `SingleColor`: a material without shading.

use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use common::{ArgumentError, Color, argument};

use crate::{Lighting, Material};

/// A material whose colour does not depend on the light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SingleColor {
    pub(crate) color: Color,
}

impl SingleColor {
    /// The material of this colour.
    pub fn new(color: Color) -> Result<Self, ArgumentError> {
        let color = argument::color("colour", color)?;
        Ok(Self { color })
    }
}

impl Material for SingleColor {
    fn color_for(&self, _: &Ray, _: &Hit, _: &dyn Lighting) -> Color {
        self.color
    }
}
