//! `at` by coordinates, and `t_of` in lengths, which are divided by the length of a step.

use crate::prelude::*;

pub fn at(ray: &Ray, t: f64) -> Point3 {
    let (o, d) = (ray.origin(), ray.direction());
    Point3::new(o.x() + t * d.x(), o.y() + t * d.y(), o.z() + t * d.z())
}

pub fn t_of(ray: &Ray, point: Point3) -> f64 {
    let length = ray.direction().magnitude();
    let unit = ray.direction() * (1.0 / length);
    (point - ray.origin()).dot(unit) / length
}
