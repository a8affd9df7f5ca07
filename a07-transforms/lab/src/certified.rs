//! Certified decisions of discs and of shapes under nodes: see the laboratory of stage 4.

use std::any::Any;
use std::mem;

use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval};
use a04_lab::certified::{self, Decision, contains, enclosed};
use a04_lab::enclosure::Enclosure;
use a04_lab::formula::plane;
use a04_lab::line::Line;
use a04_lab::number::{Triple, difference, dot};
use a04_lab::support::numbers;

use a07_transforms::Disc;
use a07_transforms::kinds::KINDS;

/// Wraps a geometry to certify its decisions; of a node, those of its children for the rays in
/// their space.
pub fn geometry(mut geometry: Box<dyn Geometry>) -> Box<dyn Geometry> {
    let Some(children) = KINDS.children_mut(&mut *geometry) else {
        return certified::geometry(geometry, decide);
    };
    for child in mem::take(children) {
        children.push(self::geometry(child));
    }
    geometry
}

/// The decision for discs and for the shapes of stage 4.
pub fn decide(shape: &dyn Geometry, ray: &Ray, within: Interval) -> Decision {
    let any: &dyn Any = shape;
    match any.downcast_ref() {
        Some(disc) => hits_disc(disc, &Line::of(ray).to(), within),
        None => certified::decide(shape, ray, within),
    }
}

fn hits_disc(disc: &Disc, line: &Line<Enclosure>, within: Interval) -> Decision {
    let center = enclosed(numbers(disc, "center"));
    let normal = enclosed(numbers(disc, "normal"));
    let [radius] = enclosed(numbers(disc, "radius"));
    if dot(&line.direction, &normal).is_zero() {
        return Some(false);
    }
    let t = plane::t(&center, &normal, line);
    let hit: Triple<Enclosure> = [0, 1, 2].map(|axis| line.origin[axis] + line.direction[axis] * t);
    let from_center = difference(&hit, &center);
    let beyond = dot(&from_center, &from_center) - radius * radius;
    // The rim belongs to the disc.
    let is_beyond = if beyond.high <= 0.0 {
        Some(false)
    } else {
        beyond.sign()
    };
    match (contains(within, t), is_beyond) {
        (Some(false), _) | (_, Some(true)) => Some(false),
        (is_hit, Some(false)) => is_hit,
        (_, None) => None,
    }
}
