//! How a [`Tree`] grows: shapes are parted where rays will have to ask the
//! fewest.

use super::shapes::Shape;
use super::tree::{Child, LEVELS, Tree, WIDTH};
use crate::Bounds;

type Shapes = [(Bounds, Shape)];

/// Grows a tree over at least one shape.
pub fn grow<B>(
    tree: &mut Tree<B>,
    mut shapes: Vec<(Bounds, Shape)>,
    mut block: impl FnMut(&[Shape]) -> B,
) {
    node(tree, &mut shapes, 0, &mut block);
}

/// Adds the node of these shapes, and returns its index.
fn node<B>(
    tree: &mut Tree<B>,
    shapes: &mut Shapes,
    level: usize,
    block: &mut impl FnMut(&[Shape]) -> B,
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
            tree.blocks.push(block(&shapes));
            Child::block(tree.blocks.len() - 1)
        } else {
            Child::node(node(tree, group, level + 1, block))
        };
        children.push((bounds, child));
    }
    tree.nodes[index] = tree.node(&children);
    index
}

fn bounds(shapes: &Shapes) -> Bounds {
    Bounds::of_all(shapes.iter().map(|(bounds, _)| *bounds))
}

/// Parts the shapes into up to four groups, the most expensive one first.
fn four_groups(shapes: &mut Shapes, level: usize) -> Vec<&mut Shapes> {
    // Cuts by area alone could make a tree as deep as there are shapes. Below
    // half its levels the shapes are halved, which gets to the end of any.
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
        let middle = |shape: &(Bounds, Shape)| shape.0.middle()[axis];
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
/// None if all middles are in one place.
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
mod tests {
    use a03_rays_cameras::PixelRandom;

    use super::*;

    /// Boxes of any sizes whose middles along each axis are -7.5, -6.5 .. 7.5, in an
    /// order of its own: so each has a bin for itself.
    fn boxes(seed: u64) -> Vec<(Bounds, Shape)> {
        let shuffled = |axis: u32| {
            let random = PixelRandom::new(seed, axis, 0);
            let mut order: Vec<u32> = (0..16).collect();
            order.sort_by(|a, b| {
                let [a, b] = [a, b].map(|i| random.uniform(u64::from(*i)));
                a.total_cmp(&b)
            });
            order
        };
        let orders = [0, 1, 2].map(shuffled);
        let random = PixelRandom::new(seed, 3, 0);
        let shape = |i: u32| {
            let middle = [0, 1, 2].map(|axis| f64::from(orders[axis][i as usize]) - 7.5);
            let half = [0, 1, 2].map(|axis| 4.0 * random.uniform(u64::from(3 * i + axis)));
            let bounds = Bounds {
                min: std::array::from_fn(|axis| middle[axis] - half[axis]),
                max: std::array::from_fn(|axis| middle[axis] + half[axis]),
            };
            (bounds, Shape::Other(i))
        };
        (0..16).map(shape).collect()
    }

    /// The tests that are expected behind a cut: how many shapes a side has,
    /// times its surface.
    fn cost(shapes: &mut Shapes, axis: usize, left: usize) -> f64 {
        shapes.sort_by(|(a, _), (b, _)| a.middle()[axis].total_cmp(&b.middle()[axis]));
        let (left, right) = shapes.split_at(left);
        let cost = |side: &Shapes| side.len() as f64 * bounds(side).half_area();
        cost(left) + cost(right)
    }

    #[test]
    fn the_cheapest_cut_is_the_cheapest_of_all() {
        for seed in 0..50 {
            let mut shapes = boxes(seed);
            let (axis, left) = cheapest_cut(&shapes).unwrap();
            let found = cost(&mut shapes, axis, left);
            for axis in 0..3 {
                for left in 1..16 {
                    let other = cost(&mut shapes, axis, left);
                    // Bound: rounding of a few products and sums.
                    assert!(found <= other * (1.0 + 1e-14), "{seed}: {axis}, {left}");
                }
            }
        }
    }

    /// So many points along the diagonal of a cube of this size that begins there.
    fn cluster(count: u32, at: f64, size: f64) -> impl Iterator<Item = (Bounds, Shape)> {
        (0..count).map(move |i| {
            let point = [at + size * f64::from(i) / f64::from(count - 1); 3];
            let bounds = Bounds {
                min: point,
                max: point,
            };
            (bounds, Shape::Other(i))
        })
    }

    #[test]
    fn a_cut_lies_between_groups() {
        for (few, many) in [(2, 5), (5, 2)] {
            let shapes: Vec<_> = cluster(few, 0.0, 1.0)
                .chain(cluster(many, 90.0, 1.0))
                .collect();
            let (_, left) = cheapest_cut(&shapes).unwrap();
            assert_eq!(left, few as usize);
        }
    }

    /// Halved, a cluster costs an eighth: a half of its shapes on a quarter of its
    /// surface. The first two cost 60 and 768, the others 360 and 30; the surface
    /// alone, or the number of shapes alone, would part another one.
    #[test]
    fn the_group_that_costs_most_is_parted() {
        for (one, other, expected) in [
            (
                cluster(20, 0.0, 1e-3),
                cluster(16, 1.0, 4e-3),
                [20, 8, 4, 4],
            ),
            (
                cluster(120, 0.0, 1.0),
                cluster(10, 1e3, 1.0),
                [60, 30, 30, 10],
            ),
        ] {
            let mut shapes: Vec<_> = one.chain(other).collect();
            let groups = four_groups(&mut shapes, 0);
            let mut found: Vec<_> = groups.iter().map(|group| group.len()).collect();
            found.sort_unstable_by(|a, b| b.cmp(a));
            assert_eq!(found, expected);
        }
    }

    #[test]
    fn what_lies_in_one_place_is_not_cut() {
        let bounds = Bounds {
            min: [-1.0; 3],
            max: [1.0; 3],
        };
        assert_eq!(cheapest_cut(&[(bounds, Shape::Other(0)); 9]), None);
    }

    #[test]
    fn the_longest_axis_is_that_of_the_middles() {
        for axis in 0..3 {
            let at = |x: f64, others: f64, half: f64| {
                let (mut min, mut max) = ([others - half; 3], [others + half; 3]);
                min[axis] = x - 0.5;
                max[axis] = x + 0.5;
                (Bounds { min, max }, Shape::Other(0))
            };
            // The boxes are wider along the other axes.
            assert_eq!(
                longest_axis(&[at(-9.0, 1.0, 20.0), at(-8.0, 2.0, 5.0), at(-5.0, 2.0, 9.0)]),
                axis
            );
        }
    }
}
