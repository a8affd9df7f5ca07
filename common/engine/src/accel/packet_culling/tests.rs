//! Tests of `packet_culling`.

use crate::Ray;
use crate::accel::bvh::{Child, Node};
use crate::accel::bvh_build;
use crate::accel::ids::{Kind, Leaf, ShapeId};
use crate::accel::slabs::WIDTH;
use crate::accel::slabs::tests::{TO_THE_RIGHT, ray, space, space_of};
use crate::adaptive::PixelRandom;
use crate::lanes::is_set;
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

/// A bundle meets each box that one of its rays meets, and enters it no later; and a packet meets
/// each box that one of its own rays meets.
#[test]
fn bundles_and_packets_bound_their_rays() {
    let (mut met, mut passed, mut together, mut culled) = (0, 0, 0, 0);
    for i in 0..2_000 {
        let random = PixelRandom::new(11, i, 0);
        let number = |n: u64| 2.0 * random.uniform(n) - 1.0;
        let vector = |n: u64| DVec3::new(number(n), number(n + 1), number(n + 2));
        let (origin, way) = (3.0 * vector(0), vector(3));
        // From two packets to nine, with one to four active rays each.
        let count = 2 + i % 8;
        let rays = |packet: u32| {
            [0, 1, 2, 3].map(|lane| {
                let at = u64::from(60 + 24 * packet + 6 * lane);
                Ray {
                    origin: origin + 0.05 * vector(at),
                    direction: (way + 0.02 * vector(at + 3)).normalize(),
                }
            })
        };
        let active = |packet| 1 + (i / 8 + packet) % 15;
        let packet = |packet| RayPacket::new(rays(packet).each_ref()).filled(active(packet));
        let packets: Vec<_> = (0..count).map(packet).collect();
        let packets: Vec<_> = packets.iter().collect();
        let Some(bundle) = Bundle::new(&space(), &packets, 1.0) else {
            continue;
        };
        let slabs = PacketSlabs::new(&space(), &bundle, &packets);
        together += 1;
        let node = node(&std::array::from_fn(|k| {
            let middle = 2.0 * vector(6 + 6 * k as u64);
            let half = 0.9 * vector(9 + 6 * k as u64).abs();
            Bounds::around([middle - half, middle + half])
        }));
        let infinite = f32x8::splat(f32::INFINITY);
        let (first, of_bundle) = bundle.all.intersect(&node.planes, infinite);
        let candidates: [u32; WIDTH] =
            std::array::from_fn(|k| slabs.intersect(&node.planes_of(k), &[f32::INFINITY; PACKETS]));
        for packet in 0..count {
            for lane in (0..4).filter(|lane| is_set(active(packet), *lane)) {
                let slabs = Slabs::of_ray(&space(), &rays(packet)[lane]).unwrap();
                let (near, of_ray) = slabs.intersect(&node.planes, infinite);
                assert_eq!(of_ray & !of_bundle, 0);
                for k in (0..WIDTH).filter(|k| is_set(of_ray, *k)) {
                    assert!(first[k] <= near[k]);
                    assert!(is_set(candidates[k], packet as usize));
                }
                met += of_ray.count_ones();
            }
        }
        passed += 8 - of_bundle.count_ones();
        let all = (1 << count) - 1;
        for k in (0..WIDTH).filter(|k| is_set(of_bundle, *k)) {
            culled += (all & !candidates[k]).count_ones();
        }
    }
    let counts = [together, met, passed, culled];
    assert!(counts.iter().all(|count| *count > 200), "{counts:?}");
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
