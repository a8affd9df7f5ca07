//! `is_shadowed`: whether an object lies between a hit and a light.

use crate::prelude::*;

/// Whether any object of the world lies between the hit of `ray` and a light.
///
/// `secondary_ray(ray, hit, direction)` leaves the surface of a hit without hitting it again;
/// `world.is_hit(&ray, within)` says whether any object is hit.
pub fn is_shadowed(
    world: &World<Box<dyn Surface>>,
    ray: &Ray,
    hit: &Hit,
    light: &Illumination,
) -> bool {
    let to_light = secondary_ray(ray, hit, light.direction);
    let end = light.distance * (1.0 - 6e-8);
    world.is_hit(&to_light, Interval::before(end))
}
