//! `secondary_ray` with an offset by the sum of all magnitudes, instead of the largest.

use crate::prelude::*;

pub fn secondary_ray(ray: &Ray, hit: &Hit, direction: Vector3) -> Ray {
    let point = ray.at(hit.t);
    let coordinates = ray.origin().largest_coordinate() + point.largest_coordinate();
    let mut offset = 1e-13 * (coordinates + hit.t + hit.scale);
    if hit.geometric_normal.dot(direction) < 0.0 {
        offset = -offset;
    }
    let origin = point + Vector3::from(hit.geometric_normal) * offset;
    Ray::derived(origin, direction)
}
