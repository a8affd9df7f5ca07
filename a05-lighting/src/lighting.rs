//! `Lighting`: the light that reaches a hit.
//!
//! Materials take their light from here and not from the lights themselves. In
//! this stage all light arrives. A later one adds shadows, and no material
//! changes.

use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use common::Color;

use crate::Illumination;

/// The light around a hit.
pub trait Lighting {
    /// The light that comes from everywhere.
    fn ambient(&self) -> Color;

    /// Calls `shade` with the light of each source that reaches the hit of `ray`.
    fn for_each_light(&self, ray: &Ray, hit: &Hit, shade: &mut dyn FnMut(&Illumination));
}
