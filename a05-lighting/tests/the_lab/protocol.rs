//! The formulas of the protocol.
//!
//! Where nothing is extreme the formulas are right, so that only the extreme
//! cases make them fail.

use a02_math::{Point3, Vector3};
use a05_lighting::protocol::{
    angle, clamped_product, directional_light_illuminates, integer_product, spot_light_illuminates,
};

const BELOW: Vector3 = Vector3::new(0.0, -2.0, 0.0);

/// The point lies acos(4 / 5) = 0.6435 beside the axis.
#[test]
fn a_spot_light_ends_where_the_arc_cosine_says() {
    let point = Point3::new(3.0, -4.0, 0.0);
    for (half_angle, lit) in [(0.64, false), (0.65, true)] {
        let is_lit = spot_light_illuminates(Point3::ORIGIN, BELOW, half_angle, point);
        assert_eq!(is_lit, lit);
    }
    assert_eq!(angle(Vector3::new(3.0, -4.0, 0.0), BELOW), libm::cos(0.8));
}

#[test]
fn a_directional_light_is_dark_near_its_position_only() {
    let lit = |x| directional_light_illuminates(Point3::ORIGIN, Point3::new(x, 0.0, 0.0));
    assert_eq!([0.0, 0.000_01].map(lit), [false; 2]);
    assert_eq!([0.000_011, 5.0].map(lit), [true; 2]);
}

/// 127 · 127 = 63 · 255 + 64.
#[test]
fn products_lose_what_they_clamp_and_cut_off() {
    assert_eq!(clamped_product(0.5, 0.25), 0.125);
    assert_eq!(clamped_product(2.0, 0.5), 0.5);
    assert_eq!(integer_product(0.5, 0.5), 63.0 / 255.0);
}
