//! `Node` with normals that are brought out child by child.

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
        let mut nearest: Option<Hit> = None;
        for child in &self.children {
            let Some(mut hit) = child.hit(&inner, within) else {
                continue;
            };
            for normal in [&mut hit.normal, &mut hit.geometric_normal] {
                *normal = self.transform.normal_from_object(*normal)?;
            }
            if nearest.is_none_or(|nearest| hit.t < nearest.t) {
                nearest = Some(hit);
            }
        }
        nearest
    }
}
