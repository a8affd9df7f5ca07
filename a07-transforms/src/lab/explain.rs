//! The plans of this stage's scenes: the plans of the previous stage with nodes.

use std::any::Any;

use a04_intersections::Geometry;
use a06_shadows_reflection::ShadowedWorld;
use common::Plan;

use crate::Node;

/// Adds the nodes of a world to a plan.
pub fn nodes(plan: Plan, world: &ShadowedWorld) -> Plan {
    let objects = world.objects().objects();
    let outer = objects.filter_map(|(geometry, _)| as_node(geometry));
    let (outer, all) = outer.fold((0, 0), |(outer, all), node| (outer + 1, all + count(node)));
    match all - outer {
        _ if all == 0 => plan,
        0 => plan.needing(format!("nodes: {all}")),
        nested => plan.needing(format!("nodes: {all}, {nested} of them within others")),
    }
}

/// The geometry as a node, if it is one.
pub fn as_node(geometry: &dyn Geometry) -> Option<&Node> {
    let any: &dyn Any = geometry;
    any.downcast_ref()
}

/// Number of nodes in a tree, with its root.
fn count(node: &Node) -> usize {
    let children = node.children.iter();
    let nodes = children.filter_map(|child| as_node(&**child));
    1 + nodes.map(count).sum::<usize>()
}
