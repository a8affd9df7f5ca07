//! Reports transformed rays and the intersection tests within nodes, by wrappers around the nodes
//! and their children.

use std::any::Any;

use a03_rays_cameras::Ray;
use a03_rays_cameras::instruments::recorded::ray_step;
use a04_intersections::instruments::recorded;
use a04_intersections::{Geometry, Hit, Interval};
use common::steps::{self, StepKind};

use crate::{Node, Transform};

/// A node whose transformed rays are reported.
#[derive(Debug)]
struct RecordedNode {
    node: Box<dyn Geometry>,
    transform: Transform,
}

impl Geometry for RecordedNode {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        steps::push(StepKind::ObjectRay, |kind| {
            let section = "a07-transforms.md#the-ray-in-object-space";
            let object_ray = self.transform.ray_to_object(ray);
            ray_step(kind, "ray in object space", section, &object_ray)
        });
        self.node.hit(ray, within)
    }
}

/// Wraps the nodes in a geometry to report their work.
pub fn geometry(mut geometry: Box<dyn Geometry>) -> Box<dyn Geometry> {
    let mut number = 0;
    children(&mut geometry, |child| {
        number += 1;
        recorded::geometry(number, child, self::geometry)
    });
    let any: &dyn Any = &*geometry;
    match any.downcast_ref::<Node>().map(|node| node.transform) {
        Some(transform) => Box::new(RecordedNode {
            node: geometry,
            transform,
        }),
        None => geometry,
    }
}

/// Replaces the children of a node by this function of them; false for another geometry.
pub fn children(
    geometry: &mut Box<dyn Geometry>,
    wrapped: impl FnMut(Box<dyn Geometry>) -> Box<dyn Geometry>,
) -> bool {
    let any: &mut dyn Any = &mut **geometry;
    let Some(node) = any.downcast_mut::<Node>() else {
        return false;
    };
    let all = std::mem::take(&mut node.children);
    node.children = all.into_iter().map(wrapped).collect();
    true
}
