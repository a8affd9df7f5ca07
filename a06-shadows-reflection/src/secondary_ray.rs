//! `secondary_ray`: how a ray leaves a surface without meeting it again.
//!
//! A computed hit lies a little above or below its surface. From below, the
//! surface would shade itself: acne. So the ray starts a little above, by as
//! much as rounding can have moved the hit and not by a fixed length, which
//! would be too much in a small scene and too little in a large one.

use a02_math::{Direction, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::Hit;

/// Units of rounding error that a hit is lifted by. The error of `o + t d` is a
/// few units of the largest number in it; 64 leave room for the error of `t`.
const LIFT: f64 = 64.0 * f64::EPSILON;

/// The ray that leaves the hit of `ray` in a direction of length 1: to a light,
/// or reflected. It starts on that side of the surface to which it goes, moved
/// along the normal, so that it clears the surface at grazing angles, too.
///
/// (Physically Based Rendering, 4th edition, section 6.8, does the same with
/// an error bound for each shape.)
#[must_use]
// ANCHOR: secondary-ray
pub fn secondary_ray(ray: &Ray, hit: &Hit, direction: Vector3) -> Ray {
    let point = ray.at(hit.t);
    let magnitude = ray
        .origin()
        .largest_coordinate()
        .max(point.largest_coordinate())
        .max(hit.t);
    let lift = (LIFT * magnitude).copysign(hit.face.dot(direction));
    Ray::derived(point + Vector3::from(hit.face) * lift, direction)
}
// ANCHOR_END: secondary-ray
