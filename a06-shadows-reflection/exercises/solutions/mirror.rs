//! `trace`: the colour that a ray brings back from a world of mirrors.

use crate::prelude::*;

/// The colour that a ray brings back if it may hit `depth` surfaces in turn. The last of
/// them mirrors black.
///
/// `world.objects()` has `hit(&ray, within)`, the nearest hit and its surface, and
/// `background()`; a surface has `color_for(&ray, &hit, &lights)`, its own colour in the lights
/// that it sees, and `mirror_reflectance()`. `secondary_ray(&ray, &hit, direction)` leaves the surface.
/// `v.reflected_on(n)` mirrors a vector that points away from a surface; `ray.direction()` leads to it.
pub fn trace(world: &ShadowedWorld, ray: &Ray, depth: u32) -> Color {
    let lights = RecursiveTracer::new(world);
    // 1. Find the nearest hit; a ray without one brings back the background.
    // 2. Take the surface's own colour.
    // 3. Reflect the ray, and let it leave the surface.
    // 4. Weight what it brings back by the mirror reflectance, up to the depth.
    missing!("the colour of the ray", Color::BLACK, {
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
    })
}

testing::examples! {
    let half = Reflective::new(Color::WHITE, Color::BLACK, 1.0, Color::gray(0.5)).unwrap();
    let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0)).unwrap();
    let world = ShadowedWorld::empty(Color::BLUE, Color::gray(0.25)).unwrap();
    let world = world.with(floor, Box::new(half));
    let seen = |y, depth| {
        let ray = Ray::derived(Point3::new(0.0, 1.0, 0.0), Vector3::new(0.0, y, 0.0));
        trace(&world, &ray, depth).channels()
    };
    assert_close!(seen(1.0, 5), [0.0, 0.0, 1.0], "the background");
    assert_close!(seen(-1.0, 1), [0.25; 3], "the floor's own colour, 0.25");
    assert_close!(seen(-1.0, 2), [0.25, 0.25, 0.75], "the background in it");
    assert_close!(seen(-1.0, 0), [0.0; 3], "nothing at depth 0");
}
