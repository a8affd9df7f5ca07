//! `at` and `t_of`: the points of a ray, and the way back.

use crate::prelude::*;

/// The point `o + t d`, with `ray.origin()` and `ray.direction()`.
pub fn at(ray: &Ray, t: f64) -> Point3 {
    // 1. Scale the direction.
    // 2. Move the origin by it.
    testing::missing("the point at t", Point3::ORIGIN)
}

/// The `t` of the ray's nearest point to `point`, which is `point` itself if it lies on
/// the ray. The direction of the ray may have any length.
pub fn t_of(ray: &Ray, point: Point3) -> f64 {
    // 1. Take the displacement from the origin to the point.
    // 2. Project it on the direction.
    // 3. Measure the projection in steps of the direction, whatever its length.
    testing::missing("the t of a point", 0.0)
}

testing::examples! {
    let ray = Ray::derived(Point3::new(1.0, 0.0, 0.0), Vector3::new(0.0, 2.0, 0.0));
    assert_eq!(at(&ray, 1.5), Point3::new(1.0, 3.0, 0.0));
    assert_eq!(t_of(&ray, Point3::new(1.0, 3.0, 0.0)), 1.5);
    assert_eq!(t_of(&ray, Point3::new(7.0, 3.0, 0.0)), 1.5, "beside the ray");
    assert_eq!(t_of(&ray, Point3::new(1.0, -4.0, 0.0)), -2.0, "behind it");
}
