//! Tests of `slabs`.

use crate::accel::units::TreeBounds;
use crate::adaptive::random::PixelRandom;
use crate::lanes::is_set;
use crate::shape::Bounds;

use super::*;

/// The centre is the origin and the unit 2, so that all numbers are exact.
fn units() -> Units {
    units_of(true)
}

fn units_of(is_exact: bool) -> Units {
    let bounds = Bounds {
        min: [-2.0; 3],
        max: [2.0; 3],
    };
    Units::new(bounds, 0.0, is_exact)
}

fn ray(x: f64, direction: [f64; 3]) -> Ray {
    Ray {
        origin: DVec3::new(x, 0.0, 0.0),
        direction: direction.into(),
    }
}

fn all(lanes: f32x8) -> f32 {
    let [first, rest @ ..] = lanes.to_array();
    assert!(rest.iter().all(|lane| *lane == first));
    first
}

const TO_THE_RIGHT: [f64; 3] = [1.0, 0.0, 0.0];
const SLACK: f32 = super::SLACK as f32;

#[test]
fn lengths_are_counted_in_the_unit_of_the_tree_and_bounds_are_wider() {
    assert_eq!(units().beyond(8.0), 4.0 + 4.0 * SLACK);
    let slabs = units().ray(&ray(-4.0, TO_THE_RIGHT), 4.0).unwrap();
    assert_eq!(all(slabs.from), 2.0 - 2.0 * SLACK);
    // Twice the slack of the largest number, which is 2, and at least of 1.
    let [x, y, _] = slabs.axes;
    assert_eq!(all(x.near), -2.0 + 4.0 * SLACK);
    assert_eq!(all(x.far), -2.0 - 4.0 * SLACK);
    assert_eq!(all(y.near), 4.0 * SLACK);
    let [x, ..] = units().ray(&ray(1.0, [-1.0, 0.0, 0.0]), 4.0).unwrap().axes;
    assert_eq!(all(x.near), 0.5 - 2.0 * SLACK);
    assert_eq!(all(x.far), 0.5 + 2.0 * SLACK);
}

/// Each of the three reasons counts alone.
#[test]
fn a_ray_beyond_single_precision_has_no_slabs() {
    let holds = |x, direction, min| units().ray(&ray(x, direction), min).is_some();
    assert!(holds(2e30, TO_THE_RIGHT, 0.0));
    assert!(!holds(2e30_f64.next_up(), TO_THE_RIGHT, 0.0));
    assert!(!holds(0.0, TO_THE_RIGHT, -f64::MIN_POSITIVE));
    // Of squared length 1/2 and 2.
    assert!(holds(0.0, [0.5, 0.5, 0.0], 0.0));
    assert!(!holds(0.0, [0.5, 0.5_f64.next_down(), 0.0], 0.0));
    assert!(!holds(0.0, [1.0, 1.0, 0.0], 0.0));
    assert!(holds(0.0, [1.0, 1.0_f64.next_down(), 0.0], 0.0));
}

/// A bundle meets each box that one of its rays meets, and no later.
#[test]
fn a_bundle_bounds_its_rays() {
    let (mut met, mut passed, mut together) = (0, 0, 0);
    for i in 0..2_000 {
        let random = PixelRandom::new(11, i, 0);
        let number = |n: u64| 2.0 * random.uniform(n) - 1.0;
        let vector = |n: u64| DVec3::new(number(n), number(n + 1), number(n + 2));
        let (origin, way) = (3.0 * vector(0), vector(3));
        let rays = [0, 1, 2, 3, 4, 5, 6, 7].map(|lane| Ray {
            origin: origin + 0.05 * vector(6 + 6 * lane),
            direction: (way + 0.02 * vector(9 + 6 * lane)).normalize(),
        });
        // Of one packet or of two.
        let active = 1 + i % 255;
        let [a, b, c, d, e, f, g, h] = rays.each_ref();
        let packets = [RayPacket::new([a, b, c, d]), RayPacket::new([e, f, g, h])];
        let packets = packets.iter().zip([active & 0b1111, active >> 4]);
        let Some(bundle) = units().bundle(packets, 1.0) else {
            continue;
        };
        together += 1;
        let corners = std::array::from_fn::<_, WIDTH, _>(|k| {
            let middle = 2.0 * vector(60 + 6 * k as u64);
            let half = 0.9 * vector(63 + 6 * k as u64).abs();
            units().bounds(Bounds::around([middle - half, middle + half]), 0.0)
        });
        let planes = [0, 1, 2].map(|axis| {
            [
                f32x8::new(corners.map(|bounds| bounds.min[axis])),
                f32x8::new(corners.map(|bounds| bounds.max[axis])),
            ]
        });
        let (first, of_bundle) = bundle.enter(&planes, f32::INFINITY);
        for lane in (0..8).filter(|lane| is_set(active, *lane)) {
            let slabs = units().ray(&rays[lane], 0.0).unwrap();
            let (near, of_ray) = slabs.enter(&planes, f32::INFINITY);
            assert_eq!(of_ray & !of_bundle, 0);
            for k in (0..WIDTH).filter(|k| is_set(of_ray, *k)) {
                assert!(first[k] <= near[k]);
            }
            met += of_ray.count_ones();
        }
        passed += 8 - of_bundle.count_ones();
    }
    assert!(
        together > 500 && met > 500 && passed > 500,
        "{together}, {met}, {passed}"
    );
}

/// The ray goes farthest along x. It enters the box there at 1/2 and leaves it at 2; along y
/// from 1 to 3/2.
#[test]
fn triangles_may_be_hit_anywhere_along_the_axis_on_which_a_ray_goes_farthest() {
    let bounds = units().bounds(
        Bounds {
            min: [0.4, 0.6, -1.0],
            max: [1.6, 0.9, 1.0],
        },
        0.0,
    );
    let planes = [0, 1, 2].map(|axis| {
        [
            f32x8::splat(bounds.min[axis]),
            f32x8::splat(bounds.max[axis]),
        ]
    });
    for is_exact in [true, false] {
        let units = units_of(is_exact);
        for (min, max, is_met) in [
            (0.0, 0.4, false),
            (0.0, 0.6, !is_exact),
            (0.0, 1.1, true),
            (1.4, 9.0, true),
            (1.9, 9.0, !is_exact),
            (2.1, 9.0, false),
        ] {
            let ray = ray(0.0, [0.8, 0.6, 0.0]);
            let (_, alone) = (units.ray(&ray, min).unwrap()).enter(&planes, units.beyond(max));
            assert_eq!(alone != 0, is_met, "{min}, {max}, exact: {is_exact}");
            if min == 0.0 {
                let packet = RayPacket::new([&ray; 4]);
                let bundle = units.bundle([(&packet, 0b1111)].into_iter(), 1.0).unwrap();
                let (_, together) = bundle.enter(&planes, units.beyond(max));
                assert_eq!(together, alone);
            }
        }
    }
}

/// One of these two directions goes farthest along x, and one along y.
#[test]
fn triangles_need_a_bundle_that_goes_farthest_along_one_axis() {
    let near = [[0.71, 0.7, 0.0], [0.7, 0.71, 0.0]].map(|direction| ray(0.0, direction));
    let [a, b] = near.each_ref();
    let packet = RayPacket::new([a, b, a, b]);
    let is_bundle = |is_exact, active| {
        let rays = [(&packet, active)].into_iter();
        units_of(is_exact).bundle(rays, 1.0).is_some()
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
        units()
            .bundle([(&packet, active)].into_iter(), 0.25)
            .is_some()
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

#[test]
fn the_half_area_is_that_of_three_faces() {
    let bounds = TreeBounds {
        min: [1.0, -2.0, 3.0],
        max: [3.0, 3.0, 9.0],
    };
    // 2 · 5 + 5 · 6 + 6 · 2.
    assert_eq!(bounds.half_area(), 52.0);
    assert_eq!(TreeBounds::NOWHERE.half_area(), 0.0);
}
