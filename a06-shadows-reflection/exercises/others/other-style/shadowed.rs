//! `is_shadowed` by the nearest hit of the ray to the light.

use crate::prelude::*;

pub fn is_shadowed(
    world: &World<Box<dyn Surface>>,
    ray: &Ray,
    hit: &Hit,
    light: &Illumination,
) -> bool {
    let to_light = secondary_ray(ray, hit, light.direction);
    match world.hit(&to_light, Interval::AHEAD) {
        Some((nearest, _)) => nearest.t < light.distance * (1.0 - 6e-8),
        None => false,
    }
}
