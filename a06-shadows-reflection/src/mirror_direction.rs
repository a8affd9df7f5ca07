//! `mirror_direction`: the direction in which a mirror sends a ray.
//!
//! On a smooth triangle the shading normal leans. At grazing angles the ray that is reflected
//! about it may go into the triangle, and a mirror would show its own inside.

use a02_math::{Direction, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::Hit;

use crate::secondary_ray::OFFSET;

/// The direction, of length 1, in which the surface at the hit of `ray` mirrors it: reflected
/// about the shading normal, or, where that leads into the surface, along the surface.
///
/// (Keller et al., The Iray Light Transport Simulation and Rendering System, 2017: the shading
/// normal is bent no more than the reflected ray needs to leave the surface.)
#[must_use]
// ANCHOR: mirror-direction
pub fn mirror_direction(ray: &Ray, hit: &Hit) -> Vector3 {
    let (e, n) = (-ray.direction(), hit.normal);
    let reflected = e.reflected_on(n);
    if reflected.dot(hit.geometric_normal) < 0.0 {
        along_the_surface(e, hit)
    } else {
        reflected
    }
}

/// Reflected by `k n - e`, as always, but with the `k` for which this lies in the plane of the
/// surface.
fn along_the_surface(e: Vector3, hit: &Hit) -> Vector3 {
    let geometric = hit.geometric_normal;
    let k = e.dot(geometric) / hit.normal.dot(geometric);
    match (Vector3::from(hit.normal) * k - e).normalized() {
        // Off the plane by more than rounding, so that the ray starts on the right side.
        Some(along) => along + geometric * OFFSET,
        None => e.reflected_on(geometric),
    }
}
// ANCHOR_END: mirror-direction
