//! `Reflective`: a shiny material that also mirrors.

use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use a05_lighting::{Lighting, Material, Phong};
use common::{ArgumentError, Color, argument};

use crate::Surface;

/// A Phong material and the share of its surroundings that it mirrors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reflective {
    shiny: Phong,
    reflection: Color,
}

impl Reflective {
    /// A [`Phong`] material that also mirrors `reflection` of each channel: a
    /// share from 0 to 1, or facing mirrors would make ever more light.
    pub fn new(
        diffuse: Color,
        specular: Color,
        exponent: f64,
        reflection: Color,
    ) -> Result<Self, ArgumentError> {
        Ok(Self {
            shiny: Phong::new(diffuse, specular, exponent)?,
            reflection: argument::share("reflection", reflection)?,
        })
    }
}

/// What the surface makes of the lights. What it mirrors comes once and after
/// the sum over the lights, from the tracer.
impl Material for Reflective {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        self.shiny.color_for(ray, hit, lighting)
    }

    fn brightest(&self, ambient: Color, lights: Color) -> Color {
        self.shiny.brightest(ambient, lights)
    }

    fn as_phong(&self) -> Option<Phong> {
        Some(self.shiny)
    }

    fn answers_light(&self) -> bool {
        self.shiny.answers_light()
    }

    fn has_highlight(&self) -> bool {
        self.shiny.has_highlight()
    }
}

impl Surface for Reflective {
    fn reflection(&self) -> Color {
        self.reflection
    }
}
