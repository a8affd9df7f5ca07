//! `secondary_ray`: a ray that leaves a surface without hitting it again.
//!
//! Chapter: Shadows and reflection, section "Getting off the surface". To compare
//! afterwards: `a06-shadows-reflection/src/secondary_ray.rs`.

use a02_math::{Direction, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::Hit;

/// The ray that leaves the hit of `ray` in a direction of length 1, to either side of the
/// surface. The computed point `ray.at(hit.t)` lies a rounding error above or below the
/// surface, so the origin is offset along the normal `hit.face`, which has length 1: by
/// more than the rounding error, and by far less than anything that one could see, in
/// scenes of any size.
///
/// `point.largest_coordinate()` is the greatest magnitude of its coordinates.
pub fn secondary_ray(ray: &Ray, hit: &Hit, direction: Vector3) -> Ray {
    testing::missing(
        "the origin of the ray",
        Ray::derived(ray.at(hit.t), direction),
    )
}
