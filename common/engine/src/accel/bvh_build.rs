//! How a [`Bvh`] is built: shapes are divided where the surface area heuristic expects
//! the fewest tests.

use super::bvh::{Bvh, Child, LEVELS, WIDTH};
use super::shapes::ShapeId;
use crate::shape::Bounds;

type Shapes = [(Bounds, ShapeId)];

/// Grows a tree over at least one shape.
pub(super) fn grow<L>(
    tree: &mut Bvh<L>,
    mut shapes: Vec<(Bounds, ShapeId)>,
    mut leaf: impl FnMut(&[ShapeId]) -> L,
) {
    node(tree, &mut shapes, 0, &mut leaf);
}

/// Adds the node of these shapes, and returns its index.
fn node<L>(
    tree: &mut Bvh<L>,
    shapes: &mut Shapes,
    level: usize,
    leaf: &mut impl FnMut(&[ShapeId]) -> L,
) -> usize {
    let groups = four_groups(shapes, level);
    let index = tree.nodes.len();
    let empty = tree.node(&[]);
    tree.nodes.push(empty);
    let mut children = Vec::with_capacity(WIDTH);
    for group in groups {
        let bounds = bounds(group);
        let child = if group.len() <= WIDTH {
            let shapes: Vec<_> = group.iter().map(|(_, shape)| *shape).collect();
            tree.leaves.push(leaf(&shapes));
            Child::leaf(tree.leaves.len() - 1)
        } else {
            Child::node(node(tree, group, level + 1, leaf))
        };
        children.push((bounds, child));
    }
    tree.nodes[index] = tree.node(&children);
    index
}

fn bounds(shapes: &Shapes) -> Bounds {
    Bounds::of_all(shapes.iter().map(|(bounds, _)| *bounds))
}

/// Divides the shapes into up to four groups, the most expensive one first.
fn four_groups(shapes: &mut Shapes, level: usize) -> Vec<&mut Shapes> {
    // Cuts by area alone could make a tree with as many levels as shapes. Below half
    // of the levels the shapes are halved, for which the other half is enough.
    let halve = level >= LEVELS / 2;
    let cost = |group: &Shapes| {
        let area = if halve {
            1.0
        } else {
            bounds(group).half_area()
        };
        area * group.len() as f64
    };
    let mut groups = vec![shapes];
    while groups.len() < WIDTH {
        let large = (0..groups.len()).filter(|i| groups[*i].len() > WIDTH);
        let Some(index) = large.max_by(|i, j| cost(groups[*i]).total_cmp(&cost(groups[*j]))) else {
            break;
        };
        let group = groups.swap_remove(index);
        let cut = if halve { None } else { cheapest_cut(group) };
        let (axis, left) = cut.unwrap_or_else(|| (longest_axis(group), group.len() / 2));
        let middle = |shape: &(Bounds, ShapeId)| shape.0.middle()[axis];
        group.select_nth_unstable_by(left, |a, b| middle(a).total_cmp(&middle(b)));
        let (left, right) = group.split_at_mut(left);
        groups.extend([left, right]);
    }
    groups
}

/// The axis along which the middles of the shapes are spread farthest.
fn longest_axis(shapes: &Shapes) -> usize {
    let middles = middles(shapes);
    let extent = |axis: &usize| middles.max[*axis] - middles.min[*axis];
    let axes = 0..3;
    axes.max_by(|a, b| extent(a).total_cmp(&extent(b)))
        .unwrap_or(0)
}

fn middles(shapes: &Shapes) -> Bounds {
    Bounds::of_all(shapes.iter().map(|(bounds, _)| {
        let middle = bounds.middle();
        Bounds {
            min: middle,
            max: middle,
        }
    }))
}

const BINS: usize = 16;

/// Where to cut the shapes, sorted along an axis, so that the surface area
/// heuristic expects the fewest tests: the axis, and how many go to the left.
/// None if all middles are the same point.
///
/// (Wald, On fast Construction of SAH-based Bounding Volume Hierarchies, 2007)
fn cheapest_cut(shapes: &Shapes) -> Option<(usize, usize)> {
    let middles = middles(shapes);
    let cuts = (0..3).flat_map(|axis| {
        let (from, extent) = (middles.min[axis], middles.max[axis] - middles.min[axis]);
        let mut bins = [(0, Bounds::NOWHERE); BINS];
        if extent > 0.0 {
            for (b, _) in shapes {
                let place = (b.middle()[axis] - from) / extent * BINS as f64;
                let (count, bounds) = &mut bins[(place as usize).min(BINS - 1)];
                *count += 1;
                *bounds = bounds.union(*b);
            }
        }
        let mut from_right = [0.0; BINS];
        let (mut count, mut all) = (0, Bounds::NOWHERE);
        for bin in (1..BINS).rev() {
            count += bins[bin].0;
            all = all.union(bins[bin].1);
            from_right[bin] = count as f64 * all.half_area();
        }
        let (mut left, mut all) = (0, Bounds::NOWHERE);
        (1..BINS).map(move |bin| {
            left += bins[bin - 1].0;
            all = all.union(bins[bin - 1].1);
            (left as f64 * all.half_area() + from_right[bin], axis, left)
        })
    });
    cuts.filter(|(_, _, left)| (1..shapes.len()).contains(left))
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, axis, left)| (axis, left))
}

#[cfg(test)]
mod tests;
