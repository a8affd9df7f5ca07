//! `Lighting`: the light that reaches a hit.
//!
//! Materials take their light from here and not from the lights themselves. In
//! this stage all light arrives. A later stage adds shadows without changing any
//! material.

use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use common::Color;

use crate::Illumination;

/// The light that reaches hits.
pub trait Lighting {
    /// The ambient light.
    fn ambient(&self) -> Color;

    /// Calls `shade` with the light of each source that reaches the hit of `ray`.
    fn for_each_light(&self, ray: &Ray, hit: &Hit, shade: &mut dyn FnMut(&Illumination));
}
