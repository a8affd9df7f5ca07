//! `trace` with the formula of the reflected direction, and the depth as a case.

use crate::prelude::*;

pub fn trace(world: &ShadowedWorld, ray: &Ray, depth: u32) -> Color {
    match (depth, world.objects().hit(ray, Interval::AHEAD)) {
        (0, _) => Color::BLACK,
        (_, None) => world.objects().background(),
        (_, Some((hit, surface))) => {
            let (d, n) = (ray.direction(), Vector3::from(hit.normal));
            let next = secondary_ray(ray, &hit, d - n * (2.0 * n.dot(d)));
            let seen = trace(world, &next, depth - 1);
            seen * surface.mirror_reflectance()
                + surface.color_for(ray, &hit, &RecursiveTracer::new(world))
        }
    }
}
