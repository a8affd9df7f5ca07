//! `nodes`: what a world has of nodes, what of them is left out, and nested ones
//! flattened where a picture may have an error.

use std::any::Any;
use std::sync::Arc;

use a02_math::Point3;
use a04_intersections::{Bounds, Geometry};
use a05_lighting::LitWorld;
use common::{Bound, Plan};

use crate::{Flat, Node};

/// Shapes may move by the error allowed, times this share of the scene: less than
/// that part of a pixel, in a picture up to 4096 pixels wide of all of it.
const PIXEL: f64 = 1.0 / 4096.0;

/// The same world, trees of nodes being [flattened](Flat) that seem to move by
/// less than `max_error` of a pixel. Rays that come from `eye`, and from objects
/// no farther away than those that end, keep to this bound.
#[must_use]
pub fn flattened<S, L>(world: LitWorld<S, L>, eye: Point3, max_error: f64) -> LitWorld<S, L> {
    let reach = reach(&world, eye);
    let allowed = max_error * PIXEL * reach;
    world.replacing(|geometry| {
        let flat = Node::of(geometry).and_then(Flat::new);
        let near = flat.filter(|flat| flat.shift(reach) < allowed);
        near.map(|flat| Arc::new(flat) as _)
    })
}

/// Adds to a plan what nodes there are, and what is left out of moving rays.
#[must_use]
pub fn plan<S, L>(plan: Plan, world: &LitWorld<S, L>, eye: Point3) -> Plan {
    let (mut count, reach) = (Count::default(), reach(world, eye));
    for (geometry, _) in world.objects().objects() {
        count.add(geometry, reach);
    }
    if count.all == 0 {
        return plan;
    }
    let mut plan = plan.needing(match (count.all, count.nested) {
        (all, 0) => format!("nodes: {all}"),
        (all, nested) => format!("nodes: {all}, {nested} of them within others"),
    });
    if count.flattened > 0 {
        plan = plan.nearly_without(
            format!("{} nested nodes", count.flattened),
            "one matrix moves a ray as far as all in turn",
            Bound::Shift(count.shift / reach),
        );
    }
    if count.straight > 0 {
        let (straight, moving) = (count.straight, count.moving);
        plan = plan.without(
            format!("the matrix of {straight} of {moving} nodes"),
            "they turn nothing",
        );
    }
    plan
}

/// The largest distance from the origin of the eye and of objects that end.
fn reach<S, L>(world: &LitWorld<S, L>, eye: Point3) -> f64 {
    let bounds = world.objects().objects().map(|(g, _)| g.bounds());
    let corners = bounds.filter(|b| b.are_finite()).flat_map(Bounds::corners);
    let distance = |p: Point3| (p - Point3::ORIGIN).to_glam().length();
    corners.map(distance).fold(distance(eye), f64::max)
}

/// How many nodes there are.
#[derive(Default)]
struct Count {
    all: usize,
    nested: usize,
    /// Those that move rays, and those of them without a matrix.
    moving: usize,
    straight: usize,
    /// Nested ones that others stand for, and how far these seem to be off.
    flattened: usize,
    shift: f64,
}

impl Count {
    fn add(&mut self, geometry: &dyn Geometry, reach: f64) {
        let any: &dyn Any = geometry;
        if let Some(flat) = any.downcast_ref::<Flat>() {
            self.all += flat.replaced();
            self.nested += flat.replaced() - 1;
            self.flattened += flat.replaced() - 1;
            self.shift = self.shift.max(flat.shift(reach));
            flat.nodes().for_each(|node| self.add_moving(node));
        } else if let Some(node) = Node::of(geometry) {
            self.all += 1;
            self.add_moving(node);
            for child in node.children() {
                let before = self.all;
                self.add(&**child, reach);
                self.nested += usize::from(self.all > before);
            }
        }
    }

    fn add_moving(&mut self, node: &Node) {
        self.moving += 1;
        self.straight += usize::from(node.is_straight());
    }
}
