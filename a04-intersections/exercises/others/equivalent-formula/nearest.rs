//! `nearest` of the hits of all objects, by their order.

use crate::prelude::*;

pub fn nearest(world: &World<usize>, ray: &Ray, within: Interval) -> Option<(Hit, usize)> {
    let objects = world.objects();
    let hits = objects.filter_map(|(geometry, number)| Some((geometry.hit(ray, within)?, *number)));
    let (mut hit, number) = hits.min_by(|(a, _), (b, _)| a.t.total_cmp(&b.t))?;
    if ray.direction().dot(hit.geometric_normal) > 0.0 {
        hit.normal = -hit.normal;
        hit.geometric_normal = -hit.geometric_normal;
    }
    Some((hit, number))
}
