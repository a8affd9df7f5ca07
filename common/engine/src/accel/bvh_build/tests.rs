//! Tests of `bvh_build`.

use crate::adaptive::random::PixelRandom;

use super::*;

/// Boxes of any sizes. Along each axis their middles are -7.5, -6.5 .. 7.5, in a
/// different order, so that each has its own bin.
fn boxes(seed: u64) -> Vec<(Bounds, ShapeId)> {
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
        (bounds, ShapeId::Other(i))
    };
    (0..16).map(shape).collect()
}

/// The expected number of tests after a cut: the number of shapes on each side times
/// its surface.
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

/// `count` points along the diagonal of a cube of this size that begins at `at`.
fn cluster(count: u32, at: f64, size: f64) -> impl Iterator<Item = (Bounds, ShapeId)> {
    (0..count).map(move |i| {
        let point = [at + size * f64::from(i) / f64::from(count - 1); 3];
        let bounds = Bounds {
            min: point,
            max: point,
        };
        (bounds, ShapeId::Other(i))
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

/// After a cut, half of a cluster costs an eighth: half of its shapes on a quarter of
/// its surface. The first two cost 60 and 768, the others 360 and 30. By the surface
/// alone, or by the number of shapes alone, another cluster would be cut.
#[test]
fn the_most_expensive_group_is_cut() {
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
fn shapes_with_one_middle_are_not_cut() {
    let bounds = Bounds {
        min: [-1.0; 3],
        max: [1.0; 3],
    };
    assert_eq!(cheapest_cut(&[(bounds, ShapeId::Other(0)); 9]), None);
}

#[test]
fn the_longest_axis_has_the_largest_spread_of_middles() {
    for axis in 0..3 {
        let at = |x: f64, others: f64, half: f64| {
            let (mut min, mut max) = ([others - half; 3], [others + half; 3]);
            min[axis] = x - 0.5;
            max[axis] = x + 0.5;
            (Bounds { min, max }, ShapeId::Other(0))
        };
        // The boxes are wider along the other axes.
        assert_eq!(
            longest_axis(&[at(-9.0, 1.0, 20.0), at(-8.0, 2.0, 5.0), at(-5.0, 2.0, 9.0)]),
            axis
        );
    }
}
