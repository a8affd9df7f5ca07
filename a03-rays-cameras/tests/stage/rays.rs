//! Rays, against the second course's numbers and by their definition.

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::Ray;
use approx::assert_abs_diff_eq;
use testing::assert_refused;

fn ray(origin: [f64; 3], direction: [f64; 3]) -> Ray {
    let origin = Point3::from_glam(origin.into());
    Ray::new(origin, Vector3::from_glam(direction.into())).unwrap()
}

/// Tolerance: half of the last digit that the course gives.
#[test]
fn second_course_points_on_a_bounded_ray() {
    let bounded = ray([0.0; 3], [3.0, 5.0, 3.0]).bounded(30.0).unwrap();
    let at_1 = Point3::new(0.457_496, 0.762_493, 0.457_496);
    let at_2_5 = Point3::new(1.143_739, 1.906_232, 1.143_739);
    assert_abs_diff_eq!(bounded.at(1.0).unwrap(), at_1, epsilon = 5e-7);
    assert_abs_diff_eq!(bounded.at(2.5).unwrap(), at_2_5, epsilon = 5e-7);
}

#[test]
fn a_bounded_ray_has_both_its_ends_and_nothing_beyond() {
    let bounded = ray([0.0; 3], [0.0, 0.0, -2.0]).bounded(30.0).unwrap();
    assert_eq!(bounded.at(0.0), Some(Point3::ORIGIN));
    assert_eq!(bounded.at(30.0), Some(Point3::new(0.0, 0.0, -30.0)));
    for outside in [-10.0, -5e-324, 30.000_000_000_000_004, 50.0, f64::NAN] {
        assert_eq!(bounded.at(outside), None);
    }
    for bad in [-1.0, f64::NAN] {
        let bounded = ray([0.0; 3], [1.0; 3]).bounded(bad);
        assert_refused(bounded, "upper bound is", "at least 0");
    }
}

#[test]
fn a_ray_is_never_degenerate() {
    for length in [1e-300, 1.0, 1e300] {
        let d = ray([0.0; 3], [length, length, -length]).direction();
        assert_abs_diff_eq!(d.dot(d), 1.0, epsilon = 4.0 * f64::EPSILON);
    }
    let x = Vector3::new(1.0, 0.0, 0.0);
    for bad in [0.0, f64::NAN, f64::INFINITY] {
        let ray = Ray::new(Point3::ORIGIN, x * bad);
        assert_refused(ray, "direction is", "not all of them 0");
    }
    for bad in [1e101, f64::NAN, f64::NEG_INFINITY] {
        let ray = Ray::new(Point3::new(0.0, bad, 0.0), x);
        assert_refused(ray, "origin is", "from -1e100 to 1e100");
    }
}
