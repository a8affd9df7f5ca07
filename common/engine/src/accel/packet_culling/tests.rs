//! Tests of `packet_culling`. That bundles and packets bound their rays is seen by the comparison of
//! random worlds with the lesson in stage 6.

use crate::accel::bvh::{Child, Node};
use crate::accel::bvh_build;
use crate::accel::ids::{Kind, Leaf, ShapeId};
use crate::accel::slabs::WIDTH;
use crate::accel::slabs::tests::{TO_THE_RIGHT, ray, space, space_of};
use crate::shape::Bounds;

use super::*;

/// A node with a leaf in each of eight boxes.
fn node(bounds: &[Bounds; WIDTH]) -> Node {
    let shape = ShapeId {
        kind: Kind::Sphere,
        index: 0,
    };
    let child = |bounds| (space().bounds(bounds, 0.0), Child::Leaf(Leaf::of(shape)));
    bvh_build::node(&bounds.map(child))
}

/// A packet meets no box behind its `t_max`.
#[test]
fn packets_are_culled_at_their_own_ends() {
    let ahead = |x: f64| Bounds {
        min: [x, -1.0, -1.0],
        max: [x + 1.0, 1.0, 1.0],
    };
    let node = node(&[1.0, 3.0, 5.0, 7.0, 9.0, 11.0, 13.0, 15.0].map(ahead));
    let packet = RayPacket::new([&ray(0.0, TO_THE_RIGHT); 4]);
    let packets = [&packet; 10];
    let bundle = Bundle::new(&space(), &packets, 1.0).unwrap();
    let slabs = PacketSlabs::new(&space(), &bundle, &packets);
    let mut t_max = [f32::NEG_INFINITY; PACKETS];
    for (i, t) in [4.0, 6.0, 0.5, f64::INFINITY].into_iter().enumerate() {
        t_max[3 * i] = space().t_max(t);
    }
    let candidates = [0, 1, 2, 3].map(|child| slabs.intersect(&node.planes_of(child), &t_max));
    let [first, fourth, last] = [0, 3, 9].map(|packet| 1 << packet);
    assert_eq!(
        candidates,
        [
            first | fourth | last,
            first | fourth | last,
            fourth | last,
            last
        ]
    );
}

/// Of these two directions one goes farthest along x, and one along y.
#[test]
fn with_triangles_a_bundle_needs_a_dominant_axis() {
    let near = [[0.71, 0.7, 0.0], [0.7, 0.71, 0.0]].map(|direction| ray(0.0, direction));
    let [a, b] = near.each_ref();
    let packet = RayPacket::new([a, b, a, b]);
    let is_bundle = |is_exact, active| {
        let rays = packet.filled(active);
        Bundle::new(&space_of(is_exact), &[&rays], 1.0).is_some()
    };
    assert!(is_bundle(true, 0b1111));
    assert!(!is_bundle(false, 0b1111));
    assert!(is_bundle(false, 0b0101));
}

#[test]
fn rays_that_go_apart_are_no_bundle() {
    let is_bundle = |directions: [[f64; 3]; 2], origins: [f64; 2], active| {
        let rays = [0, 1].map(|i| ray(origins[i], directions[i]));
        let packet = RayPacket::new([&rays[0], &rays[1], &rays[0], &rays[1]]);
        let rays = packet.filled(active);
        Bundle::new(&space(), &[&rays], 0.25).is_some()
    };
    let aside = [1.0, 0.0, 0.0625];
    assert!(is_bundle([TO_THE_RIGHT, aside], [0.0; 2], 0b1111));
    // Other signs along an axis, though by little.
    let down = [1.0, 0.0, -0.0625];
    assert!(!is_bundle([TO_THE_RIGHT, down], [0.0; 2], 0b1111));
    assert!(is_bundle([TO_THE_RIGHT, down], [0.0; 2], 0b0101));
    // The origins are a sixteenth of the unit apart, and a quarter.
    assert!(is_bundle([TO_THE_RIGHT; 2], [0.0, 0.125], 0b1111));
    assert!(!is_bundle([TO_THE_RIGHT; 2], [0.0, 0.5], 0b1111));
    assert!(is_bundle([TO_THE_RIGHT; 2], [0.0, 0.5], 0b1010));
}
