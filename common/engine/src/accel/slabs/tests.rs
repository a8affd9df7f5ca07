//! Tests of `slabs`.

use crate::accel::packet_culling::Bundle;
use crate::accel::tree_space::TreeBounds;
use crate::lanes::RayPacket;
use crate::lanes::level::baseline;
use crate::shape::Bounds;

use super::*;

/// The centre is the origin and the unit 2, so that all numbers are exact.
pub fn space() -> TreeSpace {
    space_of(true)
}

pub fn space_of(is_exact: bool) -> TreeSpace {
    let bounds = Bounds {
        min: [-2.0; 3],
        max: [2.0; 3],
    };
    TreeSpace::new(bounds, 0.0, is_exact)
}

pub fn ray(x: f64, direction: [f64; 3]) -> Ray {
    Ray {
        origin: DVec3::new(x, 0.0, 0.0),
        direction: direction.into(),
    }
}

pub const TO_THE_RIGHT: [f64; 3] = [1.0, 0.0, 0.0];

#[test]
fn lengths_are_those_of_the_tree_and_slabs_are_wider() {
    const SLACK: f32 = super::SLACK as f32;
    assert_eq!(space().t_max(8.0), 4.0 + 4.0 * SLACK);
    let planes = |ray| {
        let [x, y, _] = Slabs::of_ray(baseline(), &space(), &ray).unwrap().axes;
        [x.near, x.far, y.near].map(|lanes| lanes[7])
    };
    // Twice the slack of the largest number, which is 2, and at least of 1.
    let expected = [-2.0 + 4.0 * SLACK, -2.0 - 4.0 * SLACK, 4.0 * SLACK];
    assert_eq!(planes(ray(-4.0, TO_THE_RIGHT)), expected);
    let expected = [0.5 - 2.0 * SLACK, 0.5 + 2.0 * SLACK, 2.0 * SLACK];
    assert_eq!(planes(ray(1.0, [-1.0, 0.0, 0.0])), expected);
}

/// Each of the two reasons counts alone.
#[test]
fn a_ray_beyond_single_precision_has_no_slabs() {
    let holds = |x, direction| Slabs::of_ray(baseline(), &space(), &ray(x, direction)).is_some();
    assert!(holds(2e30, TO_THE_RIGHT));
    assert!(!holds(2e30_f64.next_up(), TO_THE_RIGHT));
    // Of squared length 1/2 and 2.
    assert!(holds(0.0, [0.5, 0.5, 0.0]));
    assert!(!holds(0.0, [0.5, 0.5_f64.next_down(), 0.0]));
    assert!(!holds(0.0, [1.0, 1.0, 0.0]));
    assert!(holds(0.0, [1.0, 1.0_f64.next_down(), 0.0]));
}

/// The ray enters the box along x, the dominant axis, at 1/2 and leaves it at 2; along y from 1 to
/// 3/2. It starts at the origin, or 3/2 and 2 farther on.
#[test]
fn triangles_may_be_hit_anywhere_along_the_dominant_axis() {
    let bounds = Bounds {
        min: [0.4, 0.6, -1.0],
        max: [1.6, 0.9, 1.0],
    };
    let TreeBounds { min, max } = space().bounds(bounds, 0.0);
    let simd = baseline();
    let planes = [0, 1, 2].map(|axis| [min[axis], max[axis]]);
    for is_exact in [true, false] {
        let space = space_of(is_exact);
        for (start, t_max, is_hit) in [
            (0.0, 0.4, false),
            (0.0, 0.6, !is_exact),
            (0.0, 1.1, true),
            (1.4, 9.0, true),
            (1.9, 9.0, !is_exact),
            (2.1, 9.0, false),
        ] {
            let direction = DVec3::new(0.8, 0.6, 0.0);
            let origin = direction * start;
            let ray = Ray { origin, direction };
            let t_max = space.t_max(t_max);
            let (_, alone) = Slabs::of_ray(simd, &space, &ray)
                .unwrap()
                .intersect(&planes, t_max);
            assert_eq!(alone != 0, is_hit, "{start}, exact: {is_exact}");
            let packet = RayPacket::new(simd, [&ray; 4]);
            let bundle = Bundle::new(&space, &[&packet], 1.0).unwrap();
            let (_, together) = bundle.all.intersect(&planes, t_max);
            assert_eq!(together, alone);
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
    assert_eq!(TreeBounds::EMPTY.half_area(), 0.0);
}

/// The `t` of a query that is over stays below all others, however far a shape may err.
#[test]
fn no_depth_error_makes_an_end_nan() {
    let bounds = Bounds {
        min: [-1e300; 3],
        max: [1e300; 3],
    };
    let space = TreeSpace::new(bounds, f64::INFINITY, false);
    assert_eq!(space.t_max(f64::NEG_INFINITY), f32::NEG_INFINITY);
    assert_eq!(space.t_max(f64::INFINITY), f32::INFINITY);
}
