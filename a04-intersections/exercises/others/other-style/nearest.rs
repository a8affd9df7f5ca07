//! `nearest` with a comparison for each object, and a normal that is turned at once.

use crate::prelude::*;

pub fn nearest(world: &World<usize>, ray: &Ray, within: Interval) -> Option<(Hit, usize)> {
    let mut best: Option<(Hit, usize)> = None;
    for (geometry, &number) in world.objects() {
        let Some(hit) = geometry.hit(ray, within) else {
            continue;
        };
        if best.is_some_and(|(nearest, _)| nearest.t <= hit.t) {
            continue;
        }
        let side = -hit.geometric_normal.dot(ray.direction()).signum();
        let turned = Hit {
            normal: hit.normal * side,
            geometric_normal: hit.geometric_normal * side,
            ..hit
        };
        best = Some((turned, number));
    }
    best
}
