//! Tests of `bundle`.

use crate::Ray;
use crate::accel::bvh::{Child, Leaf, WIDTH};
use crate::accel::bvh_build;
use crate::accel::shapes::Kind;
use crate::accel::slabs::tests::{TO_THE_RIGHT, ray, units, units_of};
use crate::adaptive::random::PixelRandom;
use crate::lanes::is_set;
use crate::shape::Bounds;

use super::*;

/// A node with a leaf in each of eight boxes.
fn node(bounds: &[Bounds; WIDTH]) -> Node {
    let leaf = Leaf {
        kind: Kind::Sphere,
        count: 1,
        first: 0,
    };
    let child = |bounds| (units().bounds(bounds, 0.0), Child::Leaf(leaf));
    bvh_build::node(&bounds.map(child))
}

/// A bundle meets each box that one of its rays meets, and no later; and each search is told of
/// the boxes that its own rays meet.
#[test]
fn a_bundle_bounds_its_rays() {
    let (mut met, mut passed, mut together, mut apart) = (0, 0, 0, 0);
    for i in 0..2_000 {
        let random = PixelRandom::new(11, i, 0);
        let number = |n: u64| 2.0 * random.uniform(n) - 1.0;
        let vector = |n: u64| DVec3::new(number(n), number(n + 1), number(n + 2));
        let (origin, way) = (3.0 * vector(0), vector(3));
        // From two searches to nine, with one to four rays each.
        let count = 2 + i % 8;
        let rays = |search: u32| {
            [0, 1, 2, 3].map(|lane| {
                let at = u64::from(60 + 24 * search + 6 * lane);
                Ray {
                    origin: origin + 0.05 * vector(at),
                    direction: (way + 0.02 * vector(at + 3)).normalize(),
                }
            })
        };
        let active = |search| 1 + (i / 8 + search) % 15;
        let searches: Vec<_> = (0..count)
            .map(|search| RayPacket::new(rays(search).each_ref()).filled(active(search)))
            .collect();
        let searches: Vec<_> = searches.iter().collect();
        let Some(bundle) = units().bundle(&searches, 1.0) else {
            continue;
        };
        let members = units().members(&bundle, &searches);
        together += 1;
        let boxes = std::array::from_fn(|k| {
            let middle = 2.0 * vector(6 + 6 * k as u64);
            let half = 0.9 * vector(9 + 6 * k as u64).abs();
            Bounds::around([middle - half, middle + half])
        });
        let node = node(&boxes);
        let anywhere = f32x8::splat(f32::INFINITY);
        let (first, of_bundle) = bundle.all.enter(&node.planes, anywhere);
        let meeting: [u32; WIDTH] =
            std::array::from_fn(|k| members.meeting(&node, k, &[f32::INFINITY; SEARCHES]));
        for search in 0..count {
            let rays = rays(search);
            for lane in (0..4).filter(|lane| is_set(active(search), *lane)) {
                let slabs = units().ray(&rays[lane], 0.0).unwrap();
                let (near, of_ray) = slabs.enter(&node.planes, anywhere);
                assert_eq!(of_ray & !of_bundle, 0);
                for k in (0..WIDTH).filter(|k| is_set(of_ray, *k)) {
                    assert!(first[k] <= near[k]);
                    assert!(is_set(meeting[k], search as usize));
                }
                met += of_ray.count_ones();
            }
        }
        passed += 8 - of_bundle.count_ones();
        let every = (1 << count) - 1;
        for k in (0..WIDTH).filter(|k| is_set(of_bundle, *k)) {
            apart += (every & !meeting[k]).count_ones();
        }
    }
    let counts = [together, met, passed, apart];
    assert!(counts.iter().all(|count| *count > 200), "{counts:?}");
}

/// A search that has found all it looks for meets nothing any more.
#[test]
fn searches_meet_only_boxes_before_their_ends() {
    let ahead = |x: f64| Bounds {
        min: [x, -1.0, -1.0],
        max: [x + 1.0, 1.0, 1.0],
    };
    let node = node(&[1.0, 3.0, 5.0, 7.0, 9.0, 11.0, 13.0, 15.0].map(ahead));
    let packet = RayPacket::new([&ray(0.0, TO_THE_RIGHT); 4]);
    let searches = [&packet; 10];
    let bundle = units().bundle(&searches, 1.0).unwrap();
    let members = units().members(&bundle, &searches);
    let mut beyond = [f32::NEG_INFINITY; SEARCHES];
    for (i, t) in [4.0, 6.0, 0.5, f64::INFINITY].into_iter().enumerate() {
        beyond[3 * i] = units().beyond(t);
    }
    let meeting = [0, 1, 2, 3].map(|child| members.meeting(&node, child, &beyond));
    assert_eq!(
        meeting,
        [
            0b10_0000_1001,
            0b10_0000_1001,
            0b10_0000_1000,
            0b10_0000_0000
        ]
    );
}

/// One of these two directions goes farthest along x, and one along y.
#[test]
fn triangles_need_a_bundle_that_goes_farthest_along_one_axis() {
    let near = [[0.71, 0.7, 0.0], [0.7, 0.71, 0.0]].map(|direction| ray(0.0, direction));
    let [a, b] = near.each_ref();
    let packet = RayPacket::new([a, b, a, b]);
    let is_bundle = |is_exact, active| {
        let rays = packet.filled(active);
        units_of(is_exact).bundle(&[&rays], 1.0).is_some()
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
        units().bundle(&[&rays], 0.25).is_some()
    };
    let aside = [1.0, 0.0, 0.0625];
    assert!(is_bundle([TO_THE_RIGHT, aside], [0.0; 2], 0b1111));
    // Other ways along an axis, though by little.
    let down = [1.0, 0.0, -0.0625];
    assert!(!is_bundle([TO_THE_RIGHT, down], [0.0; 2], 0b1111));
    assert!(is_bundle([TO_THE_RIGHT, down], [0.0; 2], 0b0101));
    // The origins are a tenth of the unit apart, a fifth, and far apart.
    assert!(is_bundle([TO_THE_RIGHT; 2], [0.0, 0.125], 0b1111));
    assert!(!is_bundle([TO_THE_RIGHT; 2], [0.0, 0.5], 0b1111));
    assert!(is_bundle([TO_THE_RIGHT; 2], [0.0, 0.5], 0b1010));
}
