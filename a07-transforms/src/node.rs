//! `Node`: geometries under one transform, themselves a geometry.

use std::any::Any;
use std::sync::Arc;

use a02_math::Normal3;
use a03_rays_cameras::Ray;
use a04_intersections::{Bounds, Geometry, Hit, Interval};
use measure::tally::{self, Work};

use crate::Transform;
use crate::moved_bounds::moved;
use crate::straight::Straight;

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
    straight: Option<Straight>,
    children: Vec<Arc<dyn Geometry>>,
}

impl Node {
    /// A node without children.
    #[must_use]
    pub fn new(transform: Transform) -> Self {
        Self {
            transform,
            straight: Straight::new(&transform),
            children: Vec::new(),
        }
    }

    /// This node and one more child.
    #[must_use]
    pub fn with(mut self, child: impl Geometry + 'static) -> Self {
        self.children.push(Arc::new(child));
        self
    }
}

impl Node {
    /// The node that a geometry is, if it is one.
    pub(crate) fn of(geometry: &dyn Geometry) -> Option<&Self> {
        let any: &dyn Any = geometry;
        any.downcast_ref()
    }

    pub(crate) fn children(&self) -> impl Iterator<Item = &Arc<dyn Geometry>> {
        self.children.iter()
    }

    pub(crate) const fn transform(&self) -> &Transform {
        &self.transform
    }

    /// Whether it moves rays without a matrix.
    pub(crate) const fn is_straight(&self) -> bool {
        self.straight.is_some()
    }

    /// These children under one transform.
    pub(crate) fn over(transform: Transform, children: Vec<Arc<dyn Geometry>>) -> Self {
        Self {
            children,
            ..Self::new(transform)
        }
    }

    /// The hit as the space around the node sees it.
    fn as_seen_around(&self, hit: Hit) -> Option<Hit> {
        Some(Hit {
            t: hit.t,
            normal: self.normal_from_object(hit.normal)?,
            face: self.normal_from_object(hit.face)?,
        })
    }

    fn ray_to_object(&self, ray: &Ray) -> Ray {
        match &self.straight {
            Some(straight) => straight.ray_to_object(ray),
            None => self.transform.ray_to_object(ray),
        }
    }

    fn normal_from_object(&self, n: Normal3) -> Option<Normal3> {
        match &self.straight {
            Some(straight) => straight.normal_from_object(n),
            None => self.transform.normal_from_object(n),
        }
    }
}

impl Geometry for Node {
    // ANCHOR: hit
    fn hit(&self, ray: &Ray, mut within: Interval) -> Option<Hit> {
        tally::count(Work::MovedRay);
        tally::count_all(Work::IntersectionTest, self.children.len() as u64);
        let object_ray = self.ray_to_object(ray);
        let mut nearest = None;
        for child in &self.children {
            let hit = child.hit(&object_ray, within);
            if let Some(hit) = hit.and_then(|hit| self.as_seen_around(hit)) {
                within.max = hit.t;
                nearest = Some(hit);
            }
        }
        nearest
    }

    fn bounds(&self) -> Bounds {
        let children = self.children.iter().map(|child| child.bounds());
        let all = children.reduce(Bounds::union);
        all.map_or(Bounds::EVERYWHERE, |all| moved(all, &self.transform))
    }

    /// A node for each part of each child, with the same transform: it moves a
    /// ray to the same bits as this node does, so that its hits are the same.
    fn parts(&self) -> Option<Vec<Arc<dyn Geometry>>> {
        let part = |child: Arc<dyn Geometry>| -> Arc<dyn Geometry> {
            Arc::new(Self::over(self.transform, vec![child]))
        };
        let parts = |child: &Arc<dyn Geometry>| {
            let own = || vec![Arc::clone(child)];
            child.parts().unwrap_or_else(own)
        };
        let parts: Vec<_> = self.children.iter().flat_map(parts).map(part).collect();
        (parts.len() > 1).then_some(parts)
    }
    // ANCHOR_END: hit
}
