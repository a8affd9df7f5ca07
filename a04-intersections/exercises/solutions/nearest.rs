//! `nearest`: the nearest hit among all objects of a world.

use crate::prelude::*;

/// The nearest hit within the interval, and the number of the object there.
///
/// `for (geometry, number) in world.objects()` visits all objects. Where the face of the
/// result looks along the ray, `hit.normal` and `hit.geometric_normal` are both turned;
/// `n.dot(ray.direction())` is a dot product.
pub fn nearest(world: &World<usize>, ray: &Ray, within: Interval) -> Option<(Hit, usize)> {
    // 1. Ask each object for its hit within the interval.
    // 2. Keep the nearest hit so far, and the number of its object.
    // 3. Turn both normals where the face looks along the ray.
    missing!("the nearest hit", None, {
        let mut until_nearest = within;
        let mut nearest = None;
        for (geometry, number) in world.objects() {
            if let Some(hit) = geometry.hit(ray, until_nearest) {
                until_nearest.max = hit.t;
                nearest = Some((hit, *number));
            }
        }
        let (mut hit, number) = nearest?;
        if hit.geometric_normal.dot(ray.direction()) > 0.0 {
            hit.normal = -hit.normal;
            hit.geometric_normal = -hit.geometric_normal;
        }
        Some((hit, number))
    })
}

testing::examples! {
    let mut world = World::new(Color::BLACK).unwrap();
    for (z, number) in [(-6.0, 30), (-3.0, 10), (-9.0, 20)] {
        world = world.with(Sphere::new(Point3::new(0.0, 0.0, z), 1.0).unwrap(), number);
    }
    let hit = |z, within| {
        let ray = Ray::derived(Point3::new(0.0, 0.0, z), Vector3::new(0.0, 0.0, -1.0));
        nearest(&world, &ray, within).map(|(hit, number)| (hit.t, hit.normal.z(), number as f64))
    };
    assert_close!(hit(0.0, Interval::AHEAD), Some((2.0, 1.0, 10.0)), "the first of three spheres");
    assert_close!(hit(-3.0, Interval::AHEAD), Some((1.0, 1.0, 10.0)), "from inside");
    let after = Interval { min: 4.5, max: 9.5 };
    assert_close!(hit(0.0, after), Some((5.0, 1.0, 30.0)), "the first after t = 4.5");
    assert!(hit(0.0, Interval::before(1.5)).is_none(), "none before t = 1.5");
}
