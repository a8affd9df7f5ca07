//! `is_shadowed`: whether an object lies between a hit and a light.

use a03_rays_cameras::Ray;
use a04_intersections::{Hit, Interval, World};
use a05_lighting::Illumination;

use crate::secondary_ray;

/// Fraction of the distance to a light within which objects cast a shadow. A lamp
/// may be fixed to an object, a ceiling for example, which must not block it. The
/// shadow ray is offset and parallel to the exact ray, so it hits the ceiling a
/// little before the distance of the light: by a few times the offset, which is
/// far less than 2^-24 of the distance.
pub(crate) const BEFORE_THE_LIGHT: f64 = 1.0 - 1.0 / 16_777_216.0;

/// Whether any object of the world lies between the hit of `ray` and a light. It
/// need not be the nearest object, so the search ends at the first hit.
#[must_use]
// ANCHOR: is-shadowed
pub fn is_shadowed<S>(world: &World<S>, ray: &Ray, hit: &Hit, light: &Illumination) -> bool {
    let to_light = secondary_ray(ray, hit, light.direction);
    let between = Interval::before(light.distance * BEFORE_THE_LIGHT);
    world.is_hit(&to_light, between)
}
// ANCHOR_END: is-shadowed
