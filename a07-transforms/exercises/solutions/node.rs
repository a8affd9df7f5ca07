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
        // 1. Bring the ray to the space of the children.
        // 2. Find the nearest hit of all children within the interval; t is the same there.
        // 3. Bring both normals of the hit to the space around the node.
        missing!("the nearest hit of the children", None, {
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
        })
    }
}

testing::examples! {
    let wide = Transform::IDENTITY.scale(2.0, 1.0, 1.0).unwrap();
    let [small, large] = [0.5, 1.0].map(|r| Sphere::new(Point3::ORIGIN, r).unwrap());
    let node = Node::new(wide).with(small).with(large);
    let hit = |within| {
        let ray = Ray::derived(Point3::new(8.0, 0.0, 0.0), Vector3::new(-1.0, 0.0, 0.0));
        node.hit(&ray, within).map(|hit| (hit.t, hit.normal.x()))
    };
    assert_close!(hit(Interval::AHEAD), Some((6.0, 1.0)), "the large ball, twice as wide");
    assert_close!(hit(Interval { min: 6.5, max: 8.0 }), Some((7.0, 1.0)), "the small one in it");
    assert!(hit(Interval::before(5.5)).is_none(), "no hit before t = 5.5");
}
