//! Tests of `split`.

use super::*;
use crate::accel::ids::Kind;
use crate::adaptive::PixelRandom;

pub(in crate::accel) const fn item(min: [f32; 3], max: [f32; 3], index: u32) -> Item {
    Item {
        bounds: TreeBounds { min, max },
        shape: ShapeId {
            kind: Kind::Sphere,
            index,
        },
    }
}

/// Boxes of any sizes. Along each axis their centroids are -7.5, -6.5 .. 7.5, in a
/// different order, so that each has its own bin.
fn boxes(seed: u64) -> Vec<Item> {
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
        let middle = [0, 1, 2].map(|axis| orders[axis][i as usize] as f32 - 7.5);
        let half = [0, 1, 2].map(|axis| 4.0 * random.uniform(u64::from(3 * i + axis)) as f32);
        let min = std::array::from_fn(|axis| middle[axis] - half[axis]);
        item(
            min,
            std::array::from_fn(|axis| middle[axis] + half[axis]),
            i,
        )
    };
    (0..16).map(shape).collect()
}

/// The expected number of tests after a split: the number of shapes on each side times
/// its surface.
fn cost(shapes: &[Item], left: usize) -> f32 {
    let (left, right) = shapes.split_at(left);
    let cost = |side: &[Item]| side.len() as f32 * bounds(side).half_area();
    cost(left) + cost(right)
}

#[test]
fn no_split_has_a_lower_cost_than_that_of_the_heuristic() {
    for seed in 0..50 {
        let mut shapes = boxes(seed);
        let left = by_sah(&mut shapes).unwrap();
        let found = cost(&shapes, left);
        for axis in 0..3 {
            let middle = |item: &Item| item.bounds.doubled_centroid()[axis];
            shapes.sort_by(|a, b| middle(a).total_cmp(&middle(b)));
            for left in 1..16 {
                // Bound: rounding of a few products and sums.
                assert!(
                    found <= cost(&shapes, left) * (1.0 + 1e-5),
                    "{seed}: {axis}, {left}"
                );
            }
        }
    }
}

/// `count` points along the diagonal of a cube of this size that begins at `at`.
pub(in crate::accel) fn cluster(count: u32, at: f32, size: f32) -> impl Iterator<Item = Item> {
    (0..count).map(move |i| {
        let point = [at + size * i as f32 / (count - 1) as f32; 3];
        item(point, point, i)
    })
}

#[test]
fn shapes_with_one_centroid_are_split_at_the_median() {
    let mut shapes = [item([-1.0; 3], [1.0; 3], 0); 9];
    assert_eq!(by_sah(&mut shapes), None);
    assert_eq!(at_median(&mut shapes), 4);
}

#[test]
fn the_median_is_that_of_the_axis_with_the_largest_extent_of_centroids() {
    for axis in 0..3 {
        // The boxes are wider along the other axes.
        let at = |x: f32, others: f32, half: f32, index| {
            let (mut min, mut max) = ([others - half; 3], [others + half; 3]);
            (min[axis], max[axis]) = (x - 0.5, x + 0.5);
            item(min, max, index)
        };
        let mut shapes = [
            at(-5.0, 1.0, 20.0, 0),
            at(-9.0, 4.0, 5.0, 1),
            at(-7.0, 3.0, 9.0, 2),
            at(-8.0, 2.0, 9.0, 3),
        ];
        assert_eq!(at_median(&mut shapes), 2);
        let mut lower = [0, 1].map(|i| shapes[i].shape.index);
        lower.sort_unstable();
        assert_eq!(lower, [1, 3]);
    }
}
