//! `Node`: geometries under one transform, themselves a geometry.

use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval};

use crate::Transform;

/// A node of the scene graph: children with a common transform. As it is a
/// geometry, it can be a child of another node.
///
/// A long translation and a second one back lose digits in between: the
/// translation of a node should not be much larger than the scene.
///
/// Nodes in nodes should not scale lengths by more than 1e200 together: coordinates of a ray might
/// become 0 or infinite. In a scene file this is an error.
///
/// A node has one surface in the world, which all its children share. Objects of
/// different surfaces need a node each, with the same transform.
#[derive(Debug)]
pub struct Node {
    pub(crate) transform: Transform,
    pub(crate) children: Vec<Box<dyn Geometry>>,
}

impl Node {
    /// A node without children.
    #[must_use]
    pub fn new(transform: Transform) -> Self {
        Self {
            transform,
            children: Vec::new(),
        }
    }

    /// This node with one more child.
    #[must_use]
    pub fn with(mut self, child: impl Geometry) -> Self {
        self.children.push(Box::new(child));
        self
    }
}

impl Geometry for Node {
    // ANCHOR: hit
    fn hit(&self, ray: &Ray, mut within: Interval) -> Option<Hit> {
        let object_ray = self.transform.ray_to_object(ray);
        let mut nearest = None;
        for child in &self.children {
            let hit = child.hit(&object_ray, within);
            if let Some(hit) = hit.and_then(|hit| self.to_parent_space(hit, ray)) {
                within.max = hit.t;
                nearest = Some(hit);
            }
        }
        nearest
    }
    // ANCHOR_END: hit

    fn any_hit(&self, ray: &Ray, within: Interval, counts: &dyn Fn(&Hit) -> bool) -> bool {
        let object_ray = self.transform.ray_to_object(ray);
        let counts_around = |hit: &Hit| {
            let hit = self.to_parent_space(*hit, ray);
            hit.is_some_and(|hit| counts(&hit))
        };
        let mut children = self.children.iter();
        children.any(|child| child.any_hit(&object_ray, within, &counts_around))
    }
}

impl Node {
    /// The hit in the space of the parent.
    fn to_parent_space(&self, hit: Hit, ray: &Ray) -> Option<Hit> {
        Some(Hit {
            t: hit.t,
            normal: self.transform.normal_from_object(hit.normal)?,
            geometric_normal: self.transform.normal_from_object(hit.geometric_normal)?,
            scale: self.transform.scale_from_object(&hit, ray),
        })
    }
}
