//! The ray and the normal under a transform.

use crate::prelude::*;

/// The ray in the space of the object. A hit there has the same `t` as around the object,
/// so the direction keeps the length that it has.
///
/// `transform.matrix()` leads from the space of the object to the space around it, and
/// `transform.inverse()` back. Both can be multiplied by a point, and by a vector.
pub fn ray_to_object(transform: &Transform, ray: &Ray) -> Ray {
    let origin = transform.inverse() * ray.origin();
    let direction = transform.inverse() * ray.direction();
    Ray::derived(origin, direction)
}

/// A normal of the object in the space around it, of length 1, perpendicular to the
/// transformed surface; none if no direction is perpendicular.
///
/// `matrix.transposed()` has rows and columns swapped.
pub fn normal_from_object(transform: &Transform, n: Normal3) -> Option<Normal3> {
    let matrix = transform.inverse().transposed();
    let normal = matrix * Vector3::from(n);
    let normal = normal.normalized()?;
    Some(normal.as_normal())
}
