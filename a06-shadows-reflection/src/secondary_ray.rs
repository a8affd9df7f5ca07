//! `secondary_ray`: a ray that leaves a surface without hitting it again.
//!
//! A computed hit lies a little above or below its surface. From below, the
//! surface would shadow itself: acne. So the origin of the ray is offset by a
//! bound of the rounding error. A fixed length would be too much in a small
//! scene and too little in a large one.

use a02_math::{Direction, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::Hit;

/// Ray offset along the normal, relative to the largest of the numbers of ray and shape.
/// For a plane, all roundings are less than 20 epsilon; 64 leave room for other shapes.
const LIFT: f64 = 64.0 * f64::EPSILON;

/// The ray that leaves the hit of `ray` in a direction of length 1: to a light,
/// or reflected. Its origin is offset along the geometric normal, to the side of
/// its direction, so that it clears the surface at grazing angles, too.
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
        .max(hit.t)
        .max(hit.magnitude);
    let lift = (LIFT * magnitude).copysign(hit.face.dot(direction));
    Ray::derived(point + Vector3::from(hit.face) * lift, direction)
}
// ANCHOR_END: secondary-ray
