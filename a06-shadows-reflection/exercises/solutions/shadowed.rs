//! `is_shadowed`: whether an object lies between a hit and a light.

use crate::prelude::*;

/// Whether any object of the world lies between the hit of `ray` and a light.
///
/// `secondary_ray(ray, hit, direction)` leaves the surface of a hit without hitting it again;
/// `world.is_hit(&ray, within)` says whether any object is hit, and `Interval::before(t)` is the interval from 0
/// to t. For a lamp on its ceiling there are `world.any_hit(&ray, within, &|hit| …)`, whether any hit counts, and
/// `rounding_error(&ray, &hit)`, the greatest distance of a hit from its surface.
pub fn is_shadowed(
    world: &World<Box<dyn Surface>>,
    ray: &Ray,
    hit: &Hit,
    light: &Illumination,
) -> bool {
    // 1. Make the ray that leaves the hit towards the light.
    // 2. End it before the light, and before an object that the light is fixed to.
    // 3. Ask whether any object is hit on the way.
    missing!("whether an object lies between", false, {
        let to_light = secondary_ray(ray, hit, light.direction);
        let end = light.distance * (1.0 - 6e-8);
        world.is_hit(&to_light, Interval::before(end))
    })
}

testing::examples! {
    let white = || Box::new(SingleColor::new(Color::WHITE).unwrap());
    let up = Normal3::new(0.0, 1.0, 0.0);
    let is_dark = |y, r| {
        let floor = Plane::new(Point3::ORIGIN, up).unwrap();
        let ball = Sphere::new(Point3::new(0.0, y, 0.0), r).unwrap();
        let world = World::<Box<dyn Surface>>::new(Color::BLACK).unwrap();
        let world = world.with(floor, white()).with(ball, white());
        let ray = Ray::derived(Point3::new(1.0, 1.0, 0.0), Vector3::new(-1.0, -1.0, 0.0));
        let direction = Vector3::from(up);
        let light = Illumination { color: Color::WHITE, direction, distance: 8.0 };
        is_shadowed(&world, &ray, &Hit::new(1.0, up), &light)
    };
    assert!(is_dark(4.0, 1.0), "a ball on the way to the light");
    assert!(!is_dark(12.0, 1.0), "a ball beyond the light");
    assert!(!is_dark(-4.0, 1.0), "a ball on the other side");
    assert!(!is_dark(10.0, 2.0), "a ball that the lamp is fixed to");
}
