//! The lesson's nearest hit, until yours is done: `cargo learn nearest`. Then copy your file here, without
//! the examples at its end.

use crate::prelude::*;

pub fn nearest(world: &World<usize>, ray: &Ray, within: Interval) -> Option<(Hit, usize)> {
    let (hit, number) = world.hit(ray, within)?;
    Some((hit, *number))
}
