//! `nearest`: the lesson's own `World`.

use a03_rays_cameras::Ray;
use a04_intersections::{Hit, Interval, World};

pub fn nearest(world: &World<usize>, ray: &Ray, within: Interval) -> Option<(Hit, usize)> {
    world.hit(ray, within).map(|(hit, number)| (hit, *number))
}
