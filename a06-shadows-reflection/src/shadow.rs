//! `is_shadowed`: whether something stands between a hit and a light.

use a03_rays_cameras::Ray;
use a04_intersections::{Hit, Interval, World};
use a05_lighting::Illumination;

use crate::secondary_ray;

/// Where on the way to a light its shadow ray ends, as a share: an object that
/// holds the light is not in its way, whichever way its distance is rounded.
const BEFORE_THE_LIGHT: f64 = 1.0 - 8.0 * f64::EPSILON;

/// Whether anything in the world stands between the hit of `ray` and a light.
/// It need not be the nearest thing, so the search ends at the first it finds.
#[must_use]
pub fn is_shadowed<S>(world: &World<S>, ray: &Ray, hit: &Hit, light: &Illumination) -> bool {
    let to_light = secondary_ray(ray, hit, light.direction);
    let between = Interval::before(light.distance * BEFORE_THE_LIGHT);
    world.is_hit(&to_light, between)
}
