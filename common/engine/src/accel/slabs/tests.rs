//! Tests of `slabs`.

use crate::accel::units::TreeBounds;
use crate::lanes::RayPacket;
use crate::shape::Bounds;

use super::*;

/// The centre is the origin and the unit 2, so that all numbers are exact.
pub fn units() -> Units {
    units_of(true)
}

pub fn units_of(is_exact: bool) -> Units {
    let bounds = Bounds {
        min: [-2.0; 3],
        max: [2.0; 3],
    };
    Units::new(bounds, 0.0, is_exact)
}

pub fn ray(x: f64, direction: [f64; 3]) -> Ray {
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

pub const TO_THE_RIGHT: [f64; 3] = [1.0, 0.0, 0.0];
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
            let beyond = f32x8::splat(units.beyond(max));
            let (_, alone) = (units.ray(&ray, min).unwrap()).enter(&planes, beyond);
            assert_eq!(alone != 0, is_met, "{min}, {max}, exact: {is_exact}");
            if min == 0.0 {
                let packet = RayPacket::new([&ray; 4]);
                let bundle = units.bundle(&[&packet], 1.0).unwrap();
                let (_, together) = bundle.all.enter(&planes, beyond);
                assert_eq!(together, alone);
            }
        }
    }
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
