//! `secondary_ray` with an offset that has the sign of the slope, by the largest of all numbers.

use crate::prelude::*;

pub fn secondary_ray(ray: &Ray, hit: &Hit, direction: Vector3) -> Ray {
    let (o, p, n) = (ray.origin(), ray.at(hit.t), hit.geometric_normal);
    let numbers = [o.x(), o.y(), o.z(), p.x(), p.y(), p.z(), hit.t, hit.scale];
    let largest = numbers.into_iter().fold(0.0, |a: f64, b| a.max(b.abs()));
    let offset = (2e-14 * largest).copysign(n.dot(direction));
    Ray::derived(p + Vector3::from(n) * offset, direction)
}
