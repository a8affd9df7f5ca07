//! `at` and `t_of`: the points of a ray, and the way back.

use crate::prelude::*;

/// The point `o + t d`, with `ray.origin()` and `ray.direction()`.
pub fn at(ray: &Ray, t: f64) -> Point3 {
    ray.origin() + ray.direction() * t
}

/// The `t` of the ray's nearest point to `point`, which is `point` itself if it lies on
/// the ray. The direction of the ray may have any length.
pub fn t_of(ray: &Ray, point: Point3) -> f64 {
    let d = ray.direction();
    let to_point = point - ray.origin();
    let along = to_point.dot(d);
    along / d.dot(d)
}
