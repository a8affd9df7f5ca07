//! `nearest`: the nearest hit among all objects of a world.
//!
//! Chapter: Intersections, section "Hit and World". To compare afterwards:
//! `a04-intersections/src/world.rs`.

use a02_math::Direction;
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval, World};

/// The nearest hit within the interval, and the number of the object there.
///
/// `for (geometry, number) in world.objects()` visits all objects, and
/// `geometry.hit(ray, within)` is the nearest hit of one. The normals of the result,
/// `hit.normal` and `hit.face`, point to the side that the ray comes from: where the face
/// looks along the ray, both are turned.
pub fn nearest(world: &World<usize>, ray: &Ray, within: Interval) -> Option<(Hit, usize)> {
    testing::missing("the nearest hit", None)
}
