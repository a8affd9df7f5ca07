//! Tests of `bvh_build`. A shape that is in no leaf, or outside of the bounds above, is missed in the
//! comparisons with the lesson.

use rayon::ThreadPoolBuilder;

use super::*;
use crate::accel::split::tests::cluster;

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

/// Four threads divide the groups side by side, and the nodes stand in the order of one thread.
#[test]
fn threads_do_not_change_the_order_of_the_nodes() {
    let children = |threads| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build();
        let mut shapes: Vec<_> = cluster(10 * PARALLEL_ABOVE as u32, 0.0, 1.0).collect();
        let mut nodes = Vec::new();
        let root = pool
            .unwrap()
            .install(|| add_node(&mut nodes, (0, &mut shapes), 0));
        assert_eq!(root as usize, nodes.len() - 1);
        nodes.iter().map(|node| node.children).collect::<Vec<_>>()
    };
    assert_eq!(children(1), children(4));
}
