//! Planes: where rays meet them, and which rays do not.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval, Plane};
use approx::{assert_abs_diff_eq, assert_relative_eq};

const UPWARDS: Normal3 = Normal3::new(0.0, 1.0, 0.0);

fn ray([x, y, z]: [f64; 3], [dx, dy, dz]: [f64; 3]) -> Ray {
    Ray::new(Point3::new(x, y, z), Vector3::new(dx, dy, dz)).unwrap()
}

/// The plane y = -1.
fn floor() -> Plane {
    Plane::new(Point3::new(0.0, -1.0, 0.0), UPWARDS).unwrap()
}

fn t(plane: &Plane, ray: &Ray) -> Option<f64> {
    plane.hit(ray, Interval::AHEAD).map(|hit| hit.t)
}

/// Tolerance: the rounded direction and two rounded operations.
#[test]
fn a_ray_meets_a_plane_at_its_distance() {
    let down = [0.0, -1.0, 0.0];
    assert_eq!(t(&floor(), &ray([0.0; 3], down)), Some(1.0));
    assert_eq!(t(&floor(), &ray([7.0, 3.0, -2.0], down)), Some(4.0));
    assert_eq!(
        t(&floor(), &ray([0.0, -3.5, 0.0], [0.0, 1.0, 0.0])),
        Some(2.5)
    );
    // A triangle of sides 3, 4 and 5.
    let slanted = t(&floor(), &ray([0.0, 3.0, 0.0], [3.0, -4.0, 0.0])).unwrap();
    assert_relative_eq!(slanted, 5.0, max_relative = 2.0 * f64::EPSILON);
}

#[test]
fn its_normal_is_the_given_one_from_both_sides_and_of_length_1() {
    for length in [1e-200, 0.25, 1.0, 1e200] {
        let plane = Plane::new(Point3::ORIGIN, UPWARDS * length).unwrap();
        for (y, d) in [(2.0, -1.0), (-2.0, 1.0)] {
            let ray = ray([0.0, y, 0.0], [0.0, d, 0.0]);
            let hit = plane.hit(&ray, Interval::AHEAD).unwrap();
            assert_eq!((hit.t, hit.normal, hit.face), (2.0, UPWARDS, UPWARDS));
        }
    }
}

#[test]
fn a_plane_behind_the_ray_or_at_its_origin_is_not_met() {
    assert_eq!(t(&floor(), &ray([0.0; 3], [0.0, 1.0, 0.0])), None);
    for d in [[0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [1.0, -1.0, 2.0]] {
        assert_eq!(t(&floor(), &ray([3.0, -1.0, 4.0], d)), None);
    }
}

#[test]
fn parallel_rays_miss_whatever_the_sign_of_their_zeros() {
    for zero in [0.0, -0.0] {
        for y in [1.0, -1.0, -3.0] {
            assert_eq!(t(&floor(), &ray([0.0, y, 0.0], [1.0, zero, zero])), None);
        }
    }
}

#[test]
fn the_ends_of_the_interval_do_not_count() {
    let ray = ray([0.0, 3.0, 0.0], [0.0, -1.0, 0.0]);
    let hit = |min: f64, max: f64| floor().hit(&ray, Interval { min, max }).is_some();
    assert!(hit(4_f64.next_down(), 4_f64.next_up()));
    assert!(!hit(4.0, 9.0) && !hit(0.0, 4.0));
    assert!(!hit(9.0, 0.0), "an interval that ends before it starts");
    assert!(!hit(f64::NAN, 9.0) && !hit(0.0, f64::NAN));
}

#[test]
fn t_counts_in_lengths_of_the_direction() {
    for length in [1e-100, 0.5, 8.0, 1e100] {
        let ray = Ray::derived(Point3::ORIGIN, Vector3::new(0.0, -length, 0.0));
        assert_eq!(t(&floor(), &ray), Some(1.0 / length));
    }
}

/// Error of the formula: at most 2 eps (|a - o| + t) / |d · n|; as much again
/// for the normal, which is rounded to length 1.
#[test]
fn a_point_far_away_in_the_plane_costs_digits_in_proportion() {
    let n = Normal3::new(1.0, 2.0, 3.0);
    for far in [1.0, 1e6, 1e12] {
        // (3, 0, -1) and (0, 3, -2) are perpendicular to (1, 2, 3).
        for across in [Vector3::new(3.0, 0.0, -1.0), Vector3::new(0.0, 3.0, -2.0)] {
            let a = Point3::ORIGIN + across * far;
            let plane = Plane::new(a, n).unwrap();
            let d = -Vector3::from(n);
            let start = Ray::new(Point3::ORIGIN, d).unwrap().at(-5.0);
            let found = t(&plane, &Ray::new(start, d).unwrap()).unwrap();
            let bound = 4.0 * f64::EPSILON * ((a - start).magnitude() + 5.0);
            assert_abs_diff_eq!(found, 5.0, epsilon = bound);
        }
    }
}

/// Tolerance: a rounded direction and a rounded quotient.
#[test]
fn grazing_rays_meet_the_plane_far_away_but_never_at_infinity() {
    let plane = Plane::new(Point3::ORIGIN, UPWARDS).unwrap();
    for slope in [1e-15, 1e-150, 1e-300] {
        let found = t(&plane, &ray([0.0, 1.0, 0.0], [1.0, -slope, 0.0])).unwrap();
        assert_relative_eq!(found, 1.0 / slope, max_relative = 2.0 * f64::EPSILON);
    }
    // 1 / 5e-324 is greater than any number.
    let denormal = ray([0.0, 1.0, 0.0], [1.0, -5e-324, 0.0]);
    assert_eq!(t(&plane, &denormal), None);
}

#[test]
fn a_plane_at_the_end_of_the_allowed_range_is_met_exactly() {
    let far = Plane::new(Point3::new(0.0, -1e100, 0.0), UPWARDS).unwrap();
    assert_eq!(t(&far, &ray([0.0; 3], [0.0, -1.0, 0.0])), Some(1e100));
    let near = Plane::new(Point3::new(0.0, -1e-100, 0.0), UPWARDS).unwrap();
    assert_eq!(t(&near, &ray([0.0; 3], [0.0, -1.0, 0.0])), Some(1e-100));
}

#[test]
fn a_ray_of_no_numbers_meets_nothing() {
    for bad in [f64::NAN, f64::INFINITY] {
        let down = Vector3::new(0.0, -1.0, 0.0);
        let nowhere = Ray::derived(Point3::new(0.0, bad, 0.0), down);
        let anywhere = Ray::derived(Point3::ORIGIN, Vector3::new(0.0, bad, 0.0));
        assert_eq!(t(&floor(), &nowhere), None);
        assert_eq!(t(&floor(), &anywhere), None);
    }
}

#[test]
fn bad_points_and_normals_are_refused_by_name() {
    for bad in [f64::NAN, f64::INFINITY, -1e101] {
        let said = Plane::new(Point3::new(0.0, 0.0, bad), UPWARDS).unwrap_err();
        let said = said.to_string();
        assert!(said.starts_with("point a is"), "{said}");
        assert!(said.contains("from -1e100 to 1e100"), "{said}");
    }
    for bad in [0.0, -0.0, f64::NAN, f64::INFINITY] {
        let said = Plane::new(Point3::ORIGIN, Normal3::new(bad, 0.0, 0.0)).unwrap_err();
        let said = said.to_string();
        assert!(said.starts_with("normal n is"), "{said}");
        assert!(said.contains("not all of them 0"), "{said}");
    }
}
