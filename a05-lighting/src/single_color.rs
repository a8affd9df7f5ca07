//! `SingleColor`: looks the same in any light.

use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use common::{ArgumentError, Color, argument};

use crate::{Lighting, Material};

/// A material of one colour that does not ask for light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SingleColor {
    color: Color,
}

impl SingleColor {
    /// The material of this colour.
    pub fn new(color: Color) -> Result<Self, ArgumentError> {
        let color = argument::color("colour", color)?;
        Ok(Self { color })
    }
}

impl Material for SingleColor {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        if !lighting.omits() {
            lighting.for_each_light(ray, hit, &mut |_| ());
        }
        self.color
    }

    fn brightest(&self, _: Color, _: Color) -> Color {
        self.color.map(f64::abs)
    }

    fn answers_light(&self) -> bool {
        false
    }
}
