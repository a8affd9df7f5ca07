//! `is_shadowed` by the rule of the chapter for a lamp on its ceiling.

use crate::prelude::*;

pub fn is_shadowed(
    world: &World<Box<dyn Surface>>,
    ray: &Ray,
    hit: &Hit,
    light: &Illumination,
) -> bool {
    let to_light = secondary_ray(ray, hit, light.direction);
    let blocks = |found: &Hit| {
        let cosine = to_light.direction().dot(found.geometric_normal).abs();
        let behind = (light.distance - found.t) * cosine;
        let error = rounding_error(ray, hit) + rounding_error(&to_light, found);
        found.t < light.distance * (15.0 / 16.0) || behind > error
    };
    world.any_hit(&to_light, Interval::before(light.distance), &blocks)
}
