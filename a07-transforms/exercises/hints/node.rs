//! `Node`: geometries under one transform, themselves a geometry.

use crate::prelude::*;

/// A node of the scene graph: children with a common transform.
#[derive(Debug)]
pub struct Node {
    transform: Transform,
    children: Vec<Box<dyn Geometry>>,
}

impl Node {
    pub fn new(transform: Transform) -> Self {
        Self {
            transform,
            children: Vec::new(),
        }
    }

    /// This node with one more child.
    pub fn with(mut self, child: impl Geometry) -> Self {
        self.children.push(Box::new(child));
        self
    }
}

impl Geometry for Node {
    /// The nearest hit of all children whose `t` lies within the interval, with `normal` and
    /// `geometric_normal` in the space around the node.
    ///
    /// `self.transform` has `ray_to_object(ray)`, and `normal_from_object(n)`, which may be none.
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let inner_ray = self.transform.ray_to_object(ray);
        let mut until_nearest = within;
        let mut nearest = None;
        for child in &self.children {
            if let Some(hit) = child.hit(&inner_ray, until_nearest) {
                until_nearest.max = hit.t;
                nearest = Some(hit);
            }
        }
        let hit: Hit = nearest?;
        let normal = self.transform.normal_from_object(hit.normal)?;
        let geometric_normal = self.transform.normal_from_object(hit.geometric_normal)?;
        Some(Hit {
            normal,
            geometric_normal,
            ..hit
        })
    }
}
