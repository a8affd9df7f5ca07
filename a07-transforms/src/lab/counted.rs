//! Counts transformed rays and the intersection tests within nodes, by wrappers around
//! the nodes and their children.

use std::any::Any;

use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval, counted};
use a05_lighting::decorated::decorated;
use a06_shadows_reflection::ShadowedWorld;
use common::ArgumentError;
use common::tally::{self, Work};

use crate::Node;
use crate::lab::explain::as_node;

/// Wraps the nodes of a world to count their work.
pub fn world(world: ShadowedWorld) -> Result<ShadowedWorld, ArgumentError> {
    decorated(world, geometry, |surface| surface)
}

/// A node that counts the rays that it transforms, with children that count theirs.
#[derive(Debug)]
struct Counted(Node);

impl Geometry for Counted {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        tally::count(Work::MovedRay);
        self.0.hit(ray, within)
    }
}

/// Wraps the nodes in a geometry to count their work.
fn geometry(geometry: Box<dyn Geometry>) -> Box<dyn Geometry> {
    if as_node(&*geometry).is_none() {
        return geometry;
    }
    let any: Box<dyn Any> = geometry;
    let Ok(node) = any.downcast::<Node>() else {
        unreachable!("the geometry is a node");
    };
    let children = node.children.into_iter();
    Box::new(Counted(Node {
        transform: node.transform,
        children: children
            .map(self::geometry)
            .map(counted::geometry)
            .collect(),
    }))
}
