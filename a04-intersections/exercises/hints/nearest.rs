//! `nearest`: the nearest hit among all objects of a world.

use crate::prelude::*;

/// The nearest hit within the interval, and the number of the object there.
///
/// `for (geometry, number) in world.objects()` visits all objects. Where the face of the
/// result looks along the ray, `hit.normal` and `hit.geometric_normal` are both turned.
pub fn nearest(world: &World<usize>, ray: &Ray, within: Interval) -> Option<(Hit, usize)> {
    let mut until_nearest = within;
    let mut nearest = None;
    for (geometry, number) in world.objects() {
        if let Some(hit) = geometry.hit(ray, until_nearest) {
            until_nearest.max = hit.t;
            nearest = Some((hit, *number));
        }
    }
    let (mut hit, number) = nearest?;
    if hit.geometric_normal.dot(ray.direction()) > 0.0 {
        hit.normal = -hit.normal;
        hit.geometric_normal = -hit.geometric_normal;
    }
    Some((hit, number))
}
