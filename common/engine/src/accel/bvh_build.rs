//! How a [`Bvh`] is built, on all threads: top-down, by the surface area heuristic.

use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};

use super::bvh::{Bvh, Child, LEVELS, Node};
use super::ids::Leaf;
use super::slabs::WIDTH;
use super::split::{Item, at_median, bounds, by_kind, by_sah};
use super::tree_space::{TreeBounds, TreeSpace};

/// Nodes of more shapes than this are divided by several threads.
const PARALLEL_ABOVE: usize = 4_096;

/// Shapes, and the number of shapes before them in the list of all.
type Group<'i> = (usize, &'i mut [Item]);

impl Bvh {
    /// The tree of at least one shape. `renumber` gives the shapes, sorted in the order of the
    /// leaves, their final ids.
    pub fn new(space: TreeSpace, mut items: Vec<Item>, renumber: impl FnOnce(&mut [Item])) -> Self {
        let mut nodes = Vec::new();
        add_node(&mut nodes, (0, &mut items), 0);
        renumber(&mut items);
        let (mut leaves, mut width) = (0.0, 0.0);
        for child in nodes.iter_mut().flat_map(|node| &mut node.children) {
            if let Child::Leaf(leaf) = child {
                let group = &items[leaf.first as usize..][..leaf.count.into()];
                leaf.first = group[0].shape.index;
                width += bounds(group).mean_width();
                leaves += 1.0;
            }
        }
        Self {
            space,
            nodes,
            leaf_width: width / leaves,
        }
    }
}

/// Adds the node of a group after those of its children, and returns its index.
fn add_node(nodes: &mut Vec<Node>, group: Group, level: usize) -> u32 {
    let is_parallel = group.1.len() > PARALLEL_ABOVE;
    let groups = divide(group, level);
    let mut children = Vec::new();
    if is_parallel {
        let add_alone = |group: Group| {
            let mut own = Vec::new();
            let child = add_child(&mut own, group, level);
            (own, child)
        };
        let mut parts = Vec::new();
        let groups = groups.into_par_iter().with_max_len(1);
        groups.map(add_alone).collect_into_vec(&mut parts);
        // They follow in the order of the groups, whichever thread was ready first.
        for (own, (bounds, child)) in parts {
            let before = nodes.len() as u32;
            for mut node in own {
                node.children = node.children.map(|child| behind(before, child));
                nodes.push(node);
            }
            children.push((bounds, behind(before, child)));
        }
    } else {
        for group in groups {
            children.push(add_child(nodes, group, level));
        }
    }
    nodes.push(node(&children));
    nodes.len() as u32 - 1
}

/// Adds the nodes of a group, unless it is a leaf, and returns it as a child of a node of a level.
fn add_child(nodes: &mut Vec<Node>, group: Group, level: usize) -> (TreeBounds, Child) {
    let (first, group) = group;
    let child = if is_leaf(group) {
        Child::Leaf(Leaf {
            kind: group[0].shape.kind,
            count: group.len() as u8,
            first: first as u32,
        })
    } else {
        Child::Node(add_node(nodes, (first, &mut *group), level + 1))
    };
    (bounds(group), child)
}

/// A child whose node stands behind so many others.
const fn behind(others: u32, child: Child) -> Child {
    match child {
        Child::Node(index) => Child::Node(others + index),
        Child::Leaf(leaf) => Child::Leaf(leaf),
    }
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
        planes,
        children: std::array::from_fn(child),
    }
}

/// Whether a group is small enough for a leaf and of one kind.
fn is_leaf(group: &[Item]) -> bool {
    is_small(group) && is_of_one_kind(group)
}

/// Whether there are no more shapes than fit into a leaf of the kind of the first.
fn is_small(group: &[Item]) -> bool {
    group.len() <= group[0].shape.kind.leaf_capacity()
}

fn is_of_one_kind(group: &[Item]) -> bool {
    let mut others = group.iter();
    others.all(|item| item.shape.kind == group[0].shape.kind)
}

/// Divides shapes into up to eight groups, the most expensive one first; groups that could
/// be leaves only if no other is left.
fn divide(group: Group, level: usize) -> Vec<Group> {
    // Splits by area alone could make a tree with as many levels as shapes. Below half
    // of the levels the shapes are split at the median, for which the other half is enough.
    let by_median = level >= LEVELS / 2;
    let cost = |group: &[Item]| {
        let area = if by_median {
            1.0
        } else {
            bounds(group).half_area()
        };
        (!is_leaf(group), area * group.len() as f32)
    };
    let mut groups = vec![(cost(group.1), group)];
    while groups.len() < WIDTH {
        let divisible = (0..groups.len()).filter(|i| groups[*i].1.1.len() > 1);
        let expensive = |i: &usize, j: &usize| {
            let (i, j) = (groups[*i].0, groups[*j].0);
            i.0.cmp(&j.0).then(i.1.total_cmp(&j.1))
        };
        let Some(index) = divisible.max_by(expensive) else {
            break;
        };
        let (_, (first, group)) = groups.swap_remove(index);
        let left = if is_small(group) && !is_of_one_kind(group) {
            by_kind(group)
        } else if by_median {
            at_median(group)
        } else {
            by_sah(group).unwrap_or_else(|| at_median(group))
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
