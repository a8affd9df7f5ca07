//! `t_of` as the t at which the displacement to the point is perpendicular to the ray, by one step of Newton's method.

use crate::prelude::*;

pub fn at(ray: &Ray, t: f64) -> Point3 {
    ray.origin() + ray.direction() * t
}

pub fn t_of(ray: &Ray, point: Point3) -> f64 {
    let d = ray.direction();
    let slope = |t: f64| (at(ray, t) - point).dot(d);
    -slope(0.0) / d.dot(d)
}
