//! `trace`: the colour that a ray brings back from a world of mirrors.

use crate::prelude::*;

/// The colour that a ray brings back if it may hit `depth` surfaces in turn. The last of
/// them mirrors black.
///
/// `world.objects()` has `hit(&ray, within)`, the nearest hit and its surface, and
/// `background()`; a surface has `color_for(&ray, &hit, &lights)`, its own colour in the lights
/// that it sees, and `mirror_reflectance()`. `secondary_ray(&ray, &hit, direction)` leaves the surface.
pub fn trace(world: &ShadowedWorld, ray: &Ray, depth: u32) -> Color {
    let lights = RecursiveTracer::new(world);
    if depth == 0 {
        return Color::BLACK;
    }
    let Some((hit, surface)) = world.objects().hit(ray, Interval::AHEAD) else {
        return world.objects().background();
    };
    let own_color = surface.color_for(ray, &hit, &lights);
    let direction = (-ray.direction()).reflected_on(hit.normal);
    let reflected = secondary_ray(ray, &hit, direction);
    own_color + surface.mirror_reflectance() * trace(world, &reflected, depth - 1)
}
