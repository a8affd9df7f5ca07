//! Counts transformed rays and the intersection tests within nodes, by wrappers around the
//! nodes and their children.

use std::any::Any;

use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval, watched};
use common::tally::{self, Work};

use crate::Node;

/// A node that counts the rays that it transforms.
#[derive(Debug)]
struct Watched(Box<dyn Geometry>);

impl Geometry for Watched {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        tally::count(Work::MovedRay);
        self.0.hit(ray, within)
    }
}

/// Wraps the nodes in a geometry to count their work.
pub fn geometry(mut geometry: Box<dyn Geometry>) -> Box<dyn Geometry> {
    let any: &mut dyn Any = &mut *geometry;
    let Some(node) = any.downcast_mut::<Node>() else {
        return geometry;
    };
    for child in std::mem::take(&mut node.children) {
        let child = watched::geometry(self::geometry(child));
        node.children.push(child);
    }
    Box::new(Watched(geometry))
}
