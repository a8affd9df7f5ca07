//! `is_shadowed`: whether something stands between a hit and a light.

use a03_rays_cameras::Ray;
use a04_intersections::{Hit, Interval, World};
use a05_lighting::Illumination;

use crate::secondary_ray;

/// The part of the way to a light on which objects cast a shadow. A lamp may
/// be fixed to an object, say the ceiling, which must not keep its light away.
/// As the ray to it starts above the surface, and parallel to the exact way, it
/// meets the ceiling a little before the distance of the light: by a few times
/// the lift, which 2^-24 of the way exceeds by far.
pub(crate) const BEFORE_THE_LIGHT: f64 = 1.0 - 1.0 / 16_777_216.0;

/// Whether anything in the world stands between the hit of `ray` and a light.
/// It need not be the nearest object, so the search ends at the first.
#[must_use]
// ANCHOR: is-shadowed
pub fn is_shadowed<S>(world: &World<S>, ray: &Ray, hit: &Hit, light: &Illumination) -> bool {
    let to_light = secondary_ray(ray, hit, light.direction);
    let between = Interval::before(light.distance * BEFORE_THE_LIGHT);
    world.is_hit(&to_light, between)
}
// ANCHOR_END: is-shadowed
