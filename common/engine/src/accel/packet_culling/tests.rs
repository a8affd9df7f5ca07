//! Tests of `packet_culling`. That bundles and packets bound their rays is seen by the comparison of
//! random worlds with the lesson, `random_worlds` of the last laboratory.

use crate::accel::bvh::{Child, Node};
use crate::accel::bvh_build;
use crate::accel::ids::{Kind, Leaf, ShapeId};
use crate::accel::slabs::WIDTH;
use crate::accel::slabs::tests::{TO_THE_RIGHT, ray, space, space_of};
use crate::lanes::level::baseline;
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
    let packet = RayPacket::new(baseline(), [&ray(0.0, TO_THE_RIGHT); 4]);
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
    let packet = RayPacket::new(baseline(), [a, b, a, b]);
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
        let packet = RayPacket::new(baseline(), [&rays[0], &rays[1], &rays[0], &rays[1]]);
        let rays = packet.filled(active);
        Bundle::new(&space(), &[&rays], 0.25).is_some()
    };
    let aside = [1.0, 0.0, 0.0625];
    assert!(is_bundle([TO_THE_RIGHT, aside], [0.0; 2], 0b1111));
    // Both ways along an axis, though by little.
    let [up, down] = [0.03125, -0.03125].map(|z| [1.0, 0.0, z]);
    assert!(!is_bundle([up, down], [0.0; 2], 0b1111));
    assert!(is_bundle([up, down], [0.0; 2], 0b0101));
    assert!(is_bundle([TO_THE_RIGHT, down], [0.0; 2], 0b1111));
    // The origins are a sixteenth of the unit apart, and a quarter.
    assert!(is_bundle([TO_THE_RIGHT; 2], [0.0, 0.125], 0b1111));
    assert!(!is_bundle([TO_THE_RIGHT; 2], [0.0, 0.5], 0b1111));
    assert!(is_bundle([TO_THE_RIGHT; 2], [0.0, 0.5], 0b1010));
}

/// Which boxes ten packets of rays from the origin meet: all before them, and none above or below.
/// The packets take these directions in turn.
fn assert_all_meet(directions: &[[f64; 3]]) {
    let rays: Vec<_> = directions.iter().map(|d| ray(0.0, *d)).collect();
    let packets: Vec<_> = (0..10)
        .map(|i| RayPacket::new(baseline(), [&rays[i % rays.len()]; 4]))
        .collect();
    let packets: Vec<_> = packets.iter().collect();
    let bundle = Bundle::new(&space(), &packets, 1.0).unwrap();
    let ahead = |y: f64| Bounds {
        min: [1.0, y - 0.5, -0.5],
        max: [1.5, y + 0.5, 0.5],
    };
    let node = node(&[0.0, 2.0, -2.0, 0.0, 2.0, -2.0, 0.0, 2.0].map(ahead));
    let mut t_max = [f32::NEG_INFINITY; PACKETS];
    t_max[..packets.len()].fill(f32::INFINITY);
    let (_, entered) = bundle.all.intersect(&node.planes, f32::INFINITY);
    assert_eq!(entered, 0b0100_1001, "{directions:?}");
    let slabs = PacketSlabs::new(&space(), &bundle, &packets);
    for (child, expected) in [(0, 0b11_1111_1111), (1, 0), (2, 0)] {
        let met = slabs.intersect(&node.planes_of(child), &t_max);
        assert_eq!(met, expected, "{directions:?}, child {child}");
    }
}

/// A ray with the direction 0 along an axis goes with all others, whatever the sign of the 0 and
/// whichever packet has it.
#[test]
fn the_sign_of_a_zero_says_nothing() {
    let tiny = f64::from_bits(1);
    for [y, z] in [
        [0.0, 0.0],
        [-0.0, -0.0],
        [tiny, -tiny],
        [1e-40, -1e-40],
        [0.0625, -0.0625],
        [-0.0625, 0.0625],
    ] {
        for zeros in [[0.0, -0.0], [-0.0, 0.0]] {
            let [a, b] = zeros;
            let mixed = [[1.0, a, b], [1.0, y, z], [1.0, b, a], [1.0, y, a]];
            for first in 0..mixed.len() {
                let mut directions = mixed;
                directions.rotate_left(first);
                assert_all_meet(&directions);
            }
        }
    }
}

/// Neither bundle nor single ray is bounded by numbers that are none, and none of the others in a
/// packet is lost by them.
#[test]
fn rays_that_are_not_finite_are_in_no_bundle() {
    let good = ray(0.0, TO_THE_RIGHT);
    for number in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for place in 0..6 {
            let mut bad = good;
            if place < 3 {
                bad.origin[place] = number;
            } else {
                bad.direction[place - 3] = number;
            }
            assert!(
                Slabs::of_ray(baseline(), &space(), &bad).is_none(),
                "{bad:?}"
            );
            for packet in 0..6 {
                for lane in 0..4 {
                    let rays = [0, 1, 2, 3].map(|i| if i == lane { &bad } else { &good });
                    let mut packets = [RayPacket::new(baseline(), [&good; 4]); 6];
                    packets[packet] = RayPacket::new(baseline(), rays);
                    let bundle = Bundle::new(&space(), &packets.each_ref(), 1.0);
                    assert!(bundle.is_none(), "{bad:?} in lane {lane} of {packet}");
                }
            }
        }
    }
}
