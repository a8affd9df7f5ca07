//! `Node`: geometries under one transform, themselves a geometry.

use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval};
use common::tally::{self, Work};

use crate::Transform;

/// A node of the scene graph: children that are moved together. As it is a
/// geometry, it can be a child of another node.
///
/// Nodes that move a long way and back again lose the digits in between, and a
/// surface may then shade itself: what a node adds to the coordinates should
/// not be much larger than the scene.
///
/// The world gives a node one surface, which all its children share. Objects of
/// several surfaces take a node each, with the same transform.
#[derive(Debug)]
pub struct Node {
    transform: Transform,
    children: Vec<Box<dyn Geometry>>,
}

impl Node {
    /// A node without children.
    #[must_use]
    pub const fn new(transform: Transform) -> Self {
        Self {
            transform,
            children: Vec::new(),
        }
    }

    /// This node and one more child.
    #[must_use]
    pub fn with(mut self, child: impl Geometry + 'static) -> Self {
        self.children.push(Box::new(child));
        self
    }
}

impl Geometry for Node {
    fn hit(&self, ray: &Ray, mut within: Interval) -> Option<Hit> {
        tally::count(Work::MovedRay);
        tally::count_all(Work::IntersectionTest, self.children.len() as u64);
        let object_ray = self.transform.ray_to_object(ray);
        let mut nearest = None;
        for child in &self.children {
            if let Some(hit) = child.hit(&object_ray, within) {
                within.max = hit.t;
                nearest = Some(hit);
            }
        }
        let Hit { t, normal, face } = nearest?;
        Some(Hit {
            t,
            normal: self.transform.normal_from_object(normal)?,
            face: self.transform.normal_from_object(face)?,
        })
    }
}
