//! `Lighting`: what light reaches a hit.
//!
//! Materials ask this instead of the lights. Here all light arrives; once
//! there are shadows only the answer changes, and no material.

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

    /// Whether work is left out that cannot change a colour.
    fn omits(&self) -> bool {
        true
    }
}
