//! Counts transformed rays and the intersection tests within nodes, by wrappers around the
//! nodes and their children.

use std::any::Any;

use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval, watched};
use common::tally::{self, Work};

use crate::Node;

/// A node that counts the rays that it transforms, with children that count theirs.
#[derive(Debug)]
struct Watched(Node);

impl Geometry for Watched {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        tally::count(Work::MovedRay);
        self.0.hit(ray, within)
    }
}

/// Wraps the nodes in a geometry to count their work.
pub fn geometry(geometry: Box<dyn Geometry>) -> Box<dyn Geometry> {
    let any: &dyn Any = &*geometry;
    if !any.is::<Node>() {
        return geometry;
    }
    let any: Box<dyn Any> = geometry;
    let Ok(node) = any.downcast::<Node>() else {
        unreachable!("the geometry is a node");
    };
    let children = node.children.into_iter();
    Box::new(Watched(Node {
        transform: node.transform,
        children: children
            .map(self::geometry)
            .map(watched::geometry)
            .collect(),
    }))
}
