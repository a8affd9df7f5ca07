//! `secondary_ray`: a ray that leaves a surface without hitting it again.
//!
//! A computed hit lies a little above or below its surface. From below, the
//! surface would shadow itself: acne. So the origin of the ray is offset by a
//! bound of the rounding error. A fixed length that is enough in a large scene
//! would be too much in a small one.

use a02_math::{Direction, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::Hit;

/// Bound of the rounding error along the normal, relative to the largest of the numbers of
/// ray and shape. The roundings of a hit and of the new ray's own test come to at most 4
/// epsilons for a box, 11 for a plane, 24 for a sphere and 44 for a triangle.
pub(crate) const OFFSET: f64 = 64.0 * f64::EPSILON;

/// The ray that leaves the hit of `ray` in a direction of length 1: to a light,
/// or reflected. Its origin is offset along the geometric normal, to the side of
/// its direction, so that it clears the surface at grazing angles, too.
///
/// (Physically Based Rendering, 4th edition, section 6.8, does the same with
/// error bounds in other units.)
#[must_use]
// ANCHOR: secondary-ray
pub fn secondary_ray(ray: &Ray, hit: &Hit, direction: Vector3) -> Ray {
    let error = rounding_error(ray, hit);
    let leads_below = hit.geometric_normal.dot(direction) < 0.0;
    let offset = if leads_below { -error } else { error };
    Ray::derived(
        ray.at(hit.t) + Vector3::from(hit.geometric_normal) * offset,
        direction,
    )
}

/// The greatest distance of the computed hit from its surface.
#[must_use]
pub fn rounding_error(ray: &Ray, hit: &Hit) -> f64 {
    let largest = ray
        .origin()
        .largest_coordinate()
        .max(ray.at(hit.t).largest_coordinate())
        .max(hit.t)
        .max(hit.scale);
    OFFSET * largest
}
// ANCHOR_END: secondary-ray
