//! `at` and `t_of`: the points of a ray, and the way back.

use crate::prelude::*;

/// The point `o + t d`, with `ray.origin()` and `ray.direction()`.
pub fn at(ray: &Ray, t: f64) -> Point3 {
    // 1. Scale the direction.
    // 2. Move the origin by it.
    missing!("the point at t", Point3::ORIGIN, {
        ray.origin() + ray.direction() * t
    })
}

/// The `t` of the ray's nearest point to `point`, which is `point` itself if it lies on
/// the ray. The direction of the ray may have any length.
///
/// `a.dot(b)` is the dot product of vectors.
pub fn t_of(ray: &Ray, point: Point3) -> f64 {
    // 1. Take the displacement from the origin to the point.
    // 2. Project it on the direction.
    // 3. Measure the projection in steps of the direction, whatever its length.
    missing!("the t of a point", 0.0, {
        let d = ray.direction();
        let to_point = point - ray.origin();
        let along = to_point.dot(d);
        along / d.dot(d)
    })
}

testing::examples! {
    let ray = Ray::derived(Point3::new(1.0, 0.0, 0.0), Vector3::new(0.0, 2.0, 0.0));
    assert_close!(array(at(&ray, 1.5)), [1.0, 3.0, 0.0]);
    assert_close!(t_of(&ray, Point3::new(1.0, 3.0, 0.0)), 1.5);
    assert_close!(t_of(&ray, Point3::new(7.0, 3.0, 0.0)), 1.5, "beside the ray");
    assert_close!(t_of(&ray, Point3::new(1.0, -4.0, 0.0)), -2.0, "behind it");
}
