//! `Material`: how a surface answers light.

use std::fmt::Debug;

use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use common::Color;

use crate::{Lighting, Phong};

/// A material of a surface.
pub trait Material: Debug + Send + Sync {
    /// The light that goes from the hit back along the ray.
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color;

    /// What no channel of its colour exceeds in magnitude, with this ambient light
    /// and this sum of the light of all sources, both in magnitude. Infinite
    /// unless the material says better.
    fn brightest(&self, ambient: Color, lights: Color) -> Color {
        let _ = (ambient, lights);
        Color::gray(f64::INFINITY)
    }

    /// Whether the place from which it is seen changes its colour: a power for
    /// each light.
    fn has_highlight(&self) -> bool {
        false
    }

    /// The Phong material that has the same colour in any light, if there is one:
    /// four of these are shaded together.
    fn as_phong(&self) -> Option<Phong> {
        None
    }

    /// Whether the light of any source can change its colour.
    fn answers_light(&self) -> bool {
        true
    }
}
