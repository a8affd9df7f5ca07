//! `secondary_ray`: a ray that leaves a surface without hitting it again.

use crate::prelude::*;

/// The ray that leaves the hit of `ray` in a direction of length 1, to either side of the
/// surface. Its origin is `ray.at(hit.t)`, offset along the normal `hit.geometric_normal` of length 1 by
/// more than its rounding error, and by far less than one could see.
///
/// `point.largest_coordinate()` is the greatest magnitude of its coordinates.
pub fn secondary_ray(ray: &Ray, hit: &Hit, direction: Vector3) -> Ray {
    let point = ray.at(hit.t);
    let of_points = ray
        .origin()
        .largest_coordinate()
        .max(point.largest_coordinate());
    let largest = of_points.max(hit.t).max(hit.scale);
    let error = 64.0 * f64::EPSILON * largest;
    let offset = error.copysign(hit.geometric_normal.dot(direction));
    let origin = point + Vector3::from(hit.geometric_normal) * offset;
    Ray::derived(origin, direction)
}
