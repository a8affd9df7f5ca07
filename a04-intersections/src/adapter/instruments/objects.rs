//! The objects of a world by their numbers, from 1: which one a ray hits first, and their names.

use a03_rays_cameras::Ray;
use common::steps::type_name;

use crate::{Geometry, Interval, World};

/// The number of the object that a ray hits first, and the `t` of this hit.
pub fn nearest<S>(world: &World<S>, ray: &Ray) -> Option<(usize, f64)> {
    let (mut within, mut nearest) = (Interval::AHEAD, None);
    for (number, (geometry, _)) in (1..).zip(world.objects()) {
        if let Some(hit) = geometry.hit(ray, within) {
            within.max = hit.t;
            nearest = Some((number, hit.t));
        }
    }
    nearest
}

/// The name of the object of a number; empty if there is none.
pub fn object_name<S>(world: &World<S>, number: usize) -> String {
    let mut objects = (1..).zip(world.objects());
    let found = objects.find(|(own, _)| *own == number);
    found.map_or_else(String::new, |(_, (geometry, _))| name(number, geometry))
}

/// The name of an object: its number and its type.
pub fn name(number: usize, geometry: &dyn Geometry) -> String {
    format!("object {number}: {}", type_name(geometry))
}
