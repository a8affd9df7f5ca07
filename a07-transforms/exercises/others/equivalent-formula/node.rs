//! `Node` with the least of the hits of all children.

use crate::prelude::*;

#[derive(Debug)]
pub struct Node {
    transform: Transform,
    children: Vec<Box<dyn Geometry>>,
}

impl Node {
    pub fn new(transform: Transform) -> Self {
        Self {
            transform,
            children: vec![],
        }
    }

    pub fn with(mut self, child: impl Geometry) -> Self {
        self.children.push(Box::new(child));
        self
    }
}

impl Geometry for Node {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let inner = self.transform.ray_to_object(ray);
        let hits = self
            .children
            .iter()
            .filter_map(|child| child.hit(&inner, within));
        let hit = hits.min_by(|a, b| a.t.total_cmp(&b.t))?;
        let to_parent = |n| self.transform.normal_from_object(n);
        Some(Hit {
            normal: to_parent(hit.normal)?,
            geometric_normal: to_parent(hit.geometric_normal)?,
            ..hit
        })
    }
}
