//! Certified decisions of discs and of shapes under nodes: see the laboratory of stage 4.

use std::mem;

use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval};
use a04_lab::certified::{self, Decision, contains, difference, plane};
use a04_lab::enclosure::Enclosure;
use a04_lab::support::{arrays, dot, numbers};

use a07_transforms::Disc;
use a07_transforms::kinds::KINDS;

/// Wraps a geometry to certify its decisions; of a node, those of its children for the rays in
/// their space.
pub fn geometry(mut geometry: Box<dyn Geometry>) -> Box<dyn Geometry> {
    let Some(children) = KINDS.children_mut(&mut *geometry) else {
        return certified::geometry(geometry, decide);
    };
    let all = mem::take(children).into_iter();
    *children = all.map(self::geometry).collect();
    geometry
}

/// The decision for discs and for the shapes of stage 4.
pub fn decide(shape: &dyn Geometry, ray: &Ray, within: Interval) -> Decision {
    let any: &dyn std::any::Any = shape;
    let Some(disc) = any.downcast_ref::<Disc>() else {
        return certified::decide(shape, ray, within);
    };
    let line @ [o, d] = arrays(ray).map(|triple| triple.map(Enclosure::from));
    let [c, n] = ["center", "normal"].map(|key| numbers(disc, key));
    let [r] = numbers(disc, "radius");
    let [c, n] = [c, n].map(|v| v.map(Enclosure::from));
    let t = plane(&c, &n, &line);
    let at: [Enclosure; 3] = std::array::from_fn(|axis| o[axis] + d[axis] * t);
    let (from_c, r) = (difference(&at, &c), Enclosure::from(r));
    let beyond = (dot(&from_c, &from_c) - r * r).sign();
    match (contains(within, t), beyond) {
        (Some(false), _) | (_, Some(true)) => Some(false),
        (is_hit, Some(false)) => is_hit,
        (_, None) => None,
    }
}
