//! `trace` as a loop that carries the product of the weights.

use crate::prelude::*;

pub fn trace(world: &ShadowedWorld, ray: &Ray, depth: u32) -> Color {
    let lights = RecursiveTracer::new(world);
    let (mut sum, mut weight, mut ray) = (Color::BLACK, Color::WHITE, *ray);
    for _ in 0..depth {
        let Some((hit, surface)) = world.objects().hit(&ray, Interval::AHEAD) else {
            return sum + weight * world.objects().background();
        };
        sum += weight * surface.color_for(&ray, &hit, &lights);
        weight = weight * surface.mirror_reflectance();
        let direction = (-ray.direction()).reflected_on(hit.normal);
        ray = secondary_ray(&ray, &hit, direction);
    }
    sum
}
