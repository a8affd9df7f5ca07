//! How a [`Bvh`] is built, on all threads: shapes are divided where the surface area
//! heuristic expects the fewest tests.

use std::sync::{Mutex, PoisonError};

use arrayvec::ArrayVec;
use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};
use wide::f32x8;

use super::bvh::{Bvh, Child, LEVELS, Leaf, Node, WIDTH};
use super::cut::{by_kind, cheapest, halves};
use super::shapes::ShapeId;
use super::units::{TreeBounds, Units};

/// A shape to be put into a tree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Item {
    pub bounds: TreeBounds,
    pub shape: ShapeId,
}

/// Nodes of more shapes than this are divided by several threads.
const SHARED: usize = 4_096;

/// Shapes, and how many lie before them in the list of all.
type Group<'i> = (usize, &'i mut [Item]);

impl Bvh {
    /// The tree of at least one shape. `name` gives the shapes, put into the order of the
    /// leaves, their final names.
    pub fn new(units: Units, mut shapes: Vec<Item>, name: impl FnOnce(&mut [Item])) -> Self {
        let nodes = Mutex::default();
        add_node(&nodes, (0, &mut shapes), 0);
        let mut nodes = nodes.into_inner().unwrap_or_else(PoisonError::into_inner);
        name(&mut shapes);
        let (mut leaves, mut width) = (0.0, 0.0);
        for child in nodes.iter_mut().flat_map(|node| &mut node.children) {
            if let Child::Leaf(leaf) = child {
                let group = &shapes[leaf.first as usize..][..leaf.count.into()];
                leaf.first = group[0].shape.index;
                width += bounds(group).mean_width();
                leaves += 1.0;
            }
        }
        Self {
            units,
            nodes,
            leaf_width: width / leaves,
        }
    }
}

/// Adds the node of a group after those of its children, and returns its index.
fn add_node(nodes: &Mutex<Vec<Node>>, group: Group, level: usize) -> u32 {
    let is_shared = group.1.len() > SHARED;
    let child = |(first, group): Group| {
        let bounds = bounds(group);
        let child = leaf(first, group).map_or_else(
            || Child::Node(add_node(nodes, (first, group), level + 1)),
            Child::Leaf,
        );
        (bounds, child)
    };
    let groups = divide(group, level);
    let children: ArrayVec<_, WIDTH> = if is_shared {
        let children: Vec<_> = groups.into_par_iter().with_max_len(1).map(child).collect();
        children.into_iter().collect()
    } else {
        groups.into_iter().map(child).collect()
    };
    let mut nodes = nodes.lock().unwrap_or_else(PoisonError::into_inner);
    nodes.push(node(&children));
    nodes.len() as u32 - 1
}

/// A node with these children.
pub(super) fn node(children: &[(TreeBounds, Child)]) -> Node {
    let mut planes = [[[f32::INFINITY; WIDTH], [f32::NEG_INFINITY; WIDTH]]; 3];
    for (lane, (bounds, _)) in children.iter().enumerate() {
        for (axis, [min, max]) in planes.iter_mut().enumerate() {
            (min[lane], max[lane]) = (bounds.min[axis], bounds.max[axis]);
        }
    }
    // No ray meets the bounds of a missing child.
    let child = |lane: usize| {
        children
            .get(lane)
            .map_or(Child::Node(0), |(_, child)| *child)
    };
    Node {
        planes: planes.map(|sides| sides.map(f32x8::new)),
        children: std::array::from_fn(child),
    }
}

/// The leaf of a group, if it is small enough and of one kind.
fn leaf(first: usize, group: &[Item]) -> Option<Leaf> {
    let kind = group[0].shape.kind;
    is_leaf(group).then_some(Leaf {
        kind,
        count: group.len() as u8,
        first: first as u32,
    })
}

fn is_leaf(group: &[Item]) -> bool {
    is_small(group) && is_of_one_kind(group)
}

/// Whether there are no more shapes than fit into a leaf of the kind of the first.
fn is_small(group: &[Item]) -> bool {
    group.len() <= group[0].shape.kind.most_in_leaf()
}

fn is_of_one_kind(group: &[Item]) -> bool {
    let mut others = group.iter();
    others.all(|item| item.shape.kind == group[0].shape.kind)
}

pub(super) fn bounds(items: &[Item]) -> TreeBounds {
    let all = items.iter().map(|item| item.bounds);
    all.fold(TreeBounds::NOWHERE, TreeBounds::union)
}

/// Divides shapes into up to eight groups, the most expensive one first; those that could
/// be leaves only if no other is left.
fn divide(group: Group, level: usize) -> Vec<Group> {
    // Cuts by area alone could make a tree with as many levels as shapes. Below half
    // of the levels the shapes are halved, for which the other half is enough.
    let halve = level >= LEVELS / 2;
    let cost = |group: &[Item]| {
        let area = if halve {
            1.0
        } else {
            bounds(group).half_area()
        };
        (!is_leaf(group), area * group.len() as f32)
    };
    let mut groups = vec![(cost(group.1), group)];
    while groups.len() < WIDTH {
        let several = (0..groups.len()).filter(|i| groups[*i].1.1.len() > 1);
        let expensive = |i: &usize, j: &usize| {
            let (i, j) = (groups[*i].0, groups[*j].0);
            i.0.cmp(&j.0).then(i.1.total_cmp(&j.1))
        };
        let Some(index) = several.max_by(expensive) else {
            break;
        };
        let (_, (first, group)) = groups.swap_remove(index);
        let left = if is_small(group) && !is_of_one_kind(group) {
            by_kind(group)
        } else if halve {
            halves(group)
        } else {
            cheapest(group).unwrap_or_else(|| halves(group))
        };
        let (a, b) = group.split_at_mut(left);
        for group in [(first, a), (first + left, b)] {
            groups.push((cost(group.1), group));
        }
    }
    groups.into_iter().map(|(_, group)| group).collect()
}

#[cfg(test)]
mod tests;
