//! Counts and records transformed rays and the intersection tests within nodes, by wrappers around the
//! nodes and their children.

use std::any::Any;

use a03_rays_cameras::Ray;
use a03_rays_cameras::instruments::watched::ray_step;
use a04_intersections::{Geometry, Hit, Interval, watched};
use common::steps;
use common::tally::{self, Work};

use crate::{Node, Transform};

/// A node whose transformed rays are counted and recorded.
#[derive(Debug)]
struct Watched(Box<dyn Geometry>, Transform);

impl Geometry for Watched {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        tally::count(Work::MovedRay);
        steps::push(|| {
            let section = "a07-transforms.md#the-ray-in-object-space";
            let ray = self.1.ray_to_object(ray);
            ray_step("object ray", "ray in object space", section, &ray)
        });
        self.0.hit(ray, within)
    }
}

/// Wraps the nodes in a geometry to count their work.
pub fn geometry(mut geometry: Box<dyn Geometry>) -> Box<dyn Geometry> {
    let mut number = 0;
    children(&mut geometry, |child| {
        number += 1;
        watched::geometry(number, child, self::geometry)
    });
    let any: &dyn Any = &*geometry;
    match any.downcast_ref::<Node>().map(|node| node.transform) {
        Some(transform) => Box::new(Watched(geometry, transform)),
        None => geometry,
    }
}

/// Replaces the children of a node by this function of them; false for another geometry.
pub fn children(
    geometry: &mut Box<dyn Geometry>,
    wrapped: impl FnMut(Box<dyn Geometry>) -> Box<dyn Geometry>,
) -> bool {
    let any: &mut dyn Any = &mut **geometry;
    let Some(node) = any.downcast_mut::<Node>() else {
        return false;
    };
    let all = std::mem::take(&mut node.children);
    node.children = all.into_iter().map(wrapped).collect();
    true
}
