//! `at` and `t_of`: the points of a ray, and the way back.
//!
//! Chapter: Rays and cameras, section "The ray". To compare afterwards:
//! `a03-rays-cameras/src/ray.rs`.

use a02_math::{Direction, Point3};
use a03_rays_cameras::Ray;

/// The point `o + t d`, with `ray.origin()` and `ray.direction()`.
pub fn at(ray: &Ray, t: f64) -> Point3 {
    testing::missing("the point at t", Point3::ORIGIN)
}

/// The `t` of the ray's nearest point to `point`, which is `point` itself if it lies on
/// the ray. The direction of the ray may have any length.
pub fn t_of(ray: &Ray, point: Point3) -> f64 {
    testing::missing("the t of a point", 0.0)
}
