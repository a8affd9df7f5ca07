//! The formulas of the two texts.
//!
//! On small numbers the formulas are right, so that only the extreme
//! cases make them fail.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::protocol::{
    bracket_of_the_code, bracket_of_the_course, bracket_of_the_formula, mean_byte, mean_over_grid,
    normalized, pinhole_direction_of_whole_sizes, point_at,
};
use approx::assert_abs_diff_eq;

#[test]
fn the_three_brackets_differ() {
    assert_eq!(bracket_of_the_code(5.0, 4.0), 4.0);
    assert_eq!(bracket_of_the_code(5.0, 3.0), 4.0);
    assert!(bracket_of_the_code(5.0, 1.0).is_nan());
    assert_eq!(bracket_of_the_formula(5.0, 3.0), 4.5);
    assert_eq!(bracket_of_the_course(6.0, 5.0), 1.0);
    assert_eq!(bracket_of_the_course(0.0, 5.0), -0.5);
}

/// Tolerance: the tangent of half the angle is 1/2 up to rounding.
#[test]
fn the_pinhole_camera_halves_sizes_as_whole_numbers() {
    let angle = 2.0 * libm::atan(0.5);
    let halved = pinhole_direction_of_whole_sizes([7, 5], 5.5, 0.5, angle);
    let expected = normalized(Vector3::new(2.5, 1.5, -4.0));
    assert_abs_diff_eq!(halved, expected, epsilon = 4.0 * f64::EPSILON);
}

#[test]
fn a_ray_ends_at_its_bound() {
    let x = Vector3::new(2.0, 0.0, 0.0);
    let at = |t| point_at(Point3::new(1.0, 0.0, 0.0), x, 30.0, t).map(Point3::x);
    assert_eq!([0.0, 4.0, 30.0].map(at), [1.0, 5.0, 31.0].map(Some));
    assert_eq!([-1.0, 30.5].map(at), [None, None]);
}

/// 51 / 3 = 17, 53 / 3 = 17 and two thirds; 9 of 10 places fill a grid.
#[test]
fn means_of_whole_numbers_lose_the_remainder() {
    assert_eq!(mean_byte(&[10, 20, 21]), 17);
    assert_eq!(mean_byte(&[10, 20, 23]), 17);
    assert_eq!(mean_over_grid(9, 2.0), 2.0);
    assert_eq!(mean_over_grid(10, 2.0), 1.8);
}
