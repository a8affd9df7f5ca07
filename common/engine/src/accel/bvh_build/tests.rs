//! Tests of `bvh_build`.

use super::*;
use crate::accel::ids::Kind;
use crate::accel::split::tests::{cluster, item};
use crate::adaptive::PixelRandom;
use crate::shape::Bounds;

const CUBE: Bounds = Bounds {
    min: [-1.0; 3],
    max: [1.0; 3],
};

fn sizes(mut shapes: Vec<Item>) -> Vec<usize> {
    let groups = divide((0, &mut shapes), 0);
    let mut sizes: Vec<_> = groups.iter().map(|(_, group)| group.len()).collect();
    sizes.sort_unstable_by(|a, b| b.cmp(a));
    sizes
}

/// Half of a cluster costs an eighth: half of its shapes on a quarter of its surface. In
/// proportion, the first costs 640 = 640 x 1 and the second 480 = 160 x 3; split, they cost 80 and
/// 60 twice, and so on: each is split until there are eight.
#[test]
fn the_most_expensive_group_is_split() {
    let shapes = cluster(640, 0.0, 1.0).chain(cluster(160, 1e3, 3.0_f32.sqrt()));
    assert_eq!(
        sizes(shapes.collect()),
        [160, 160, 160, 160, 40, 40, 40, 40]
    );
}

/// Groups small enough for leaves are divided further while a node has room.
#[test]
fn a_node_has_room_for_eight() {
    assert_eq!(sizes(cluster(8, 0.0, 1.0).collect()), [1; 8]);
    assert_eq!(sizes(cluster(2, 0.0, 1.0).collect()), [1; 2]);
    let sizes = sizes(cluster(32, 0.0, 1.0).collect());
    assert_eq!(sizes, [4; 8]);
}

#[test]
fn each_shape_is_in_one_leaf_of_its_kind_within_all_bounds_above() {
    for count in [1, 7, 100, 10_000] {
        let space = TreeSpace::new(CUBE, 0.0, true);
        let shape = |i: u32| {
            let random = PixelRandom::new(1, i, 0);
            // Every seventh at the same place.
            let middle = [0, 1, 2].map(|axis| match i % 7 {
                0 => 0.25,
                _ => 2.0 * random.uniform(axis) as f32 - 1.0,
            });
            let mut item = item(middle.map(|x| x - 0.01), middle.map(|x| x + 0.01), i);
            item.shape.kind = if i.is_multiple_of(3) {
                Kind::Box
            } else {
                Kind::Disc
            };
            item
        };
        let shapes: Vec<_> = (0..count).map(shape).collect();
        let mut order = Vec::new();
        let tree = Bvh::new(space, shapes, |items| {
            order.extend_from_slice(items);
        });
        // The shapes were not renumbered: the first of a leaf finds the others in the order.
        let mut found = vec![0; count as usize];
        let root = tree.nodes.len() - 1;
        let mut open = vec![(
            root,
            TreeBounds {
                min: [-2.0; 3],
                max: [2.0; 3],
            },
            0,
        )];
        while let Some((index, within, level)) = open.pop() {
            assert!(level < LEVELS);
            let node = &tree.nodes[index];
            for (lane, child) in node.children.iter().enumerate() {
                let bounds = TreeBounds {
                    min: node.planes.map(|[min, _]| min.to_array()[lane]),
                    max: node.planes.map(|[_, max]| max.to_array()[lane]),
                };
                if bounds == TreeBounds::EMPTY {
                    continue;
                }
                assert_eq!(within.union(bounds), within);
                match child {
                    Child::Node(node) => open.push((*node as usize, bounds, level + 1)),
                    Child::Leaf(leaf) => {
                        let mut places = order.iter();
                        let first = places.position(|item| item.shape.index == leaf.first);
                        let group = &order[first.unwrap()..][..leaf.count.into()];
                        for item in group {
                            assert_eq!(item.shape.kind, leaf.kind);
                            assert_eq!(bounds.union(item.bounds), bounds);
                            found[item.shape.index as usize] += 1;
                        }
                    }
                }
            }
        }
        assert!(found.iter().all(|times| *times == 1));
    }
}
