//! Which rays meet a triangle, and at which distance.

use std::f64::consts::{FRAC_PI_6, PI};

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{Geometry, Hit, Interval, Triangle};
use approx::assert_abs_diff_eq;

use super::{Z, ahead, hit, point, triangle};

#[test]
fn both_sides_are_seen_and_the_normal_stays() {
    assert_eq!(hit(&triangle(), &ahead(1.0, 0.5)), Some(Hit::new(4.0, Z)));
    let from_behind = Ray::derived(point([1.0, 0.5, -2.0]), Vector3::from(Z));
    assert_eq!(hit(&triangle(), &from_behind), Some(Hit::new(2.0, Z)));
    let away = Ray::derived(point([1.0, 0.5, 4.0]), Vector3::from(Z));
    assert_eq!(hit(&triangle(), &away), None);
}

/// Tolerance: a few roundings of a distance of 3.
#[test]
fn a_slanted_ray_meets_a_slanted_triangle() {
    // In the plane x + y + z = 3; its middle is (1, 1, 1).
    let [a, b, c] = [[3.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 3.0]].map(point);
    let slanted = Triangle::new(a, b, c).unwrap();
    let ray = Ray::derived(Point3::ORIGIN, Vector3::new(0.5, 0.25, 0.25));
    let found = hit(&slanted, &ray).unwrap();
    assert_abs_diff_eq!(found.t, 3.0, epsilon = 8.0 * f64::EPSILON);
    let third = 1.0 / 3_f64.sqrt();
    let normal = Normal3::new(third, third, third);
    assert_abs_diff_eq!(found.normal, normal, epsilon = 2.0 * f64::EPSILON);
}

#[test]
fn corners_and_edges_belong_to_it_and_nothing_beyond() {
    let (before, beyond) = (-5e-324, 3_f64.next_up());
    for (x, y) in [
        (0.0, 0.0),
        (3.0, 0.0),
        (0.0, 3.0),
        (1.5, 0.0),
        (0.0, 1.5),
        (1.5, 1.5),
        (0.75, 2.25),
    ] {
        assert_eq!(hit(&triangle(), &ahead(x, y)).unwrap().t, 4.0, "({x}, {y})");
    }
    for (x, y) in [
        (before, 1.0),
        (1.0, before),
        (beyond, 0.0),
        (0.0, beyond),
        (1.5, 1.5_f64.next_up()),
        (2.25, 0.75_f64.next_up()),
    ] {
        assert_eq!(hit(&triangle(), &ahead(x, y)), None, "({x}, {y})");
    }
}

/// Seen from 2^53 away the corners of a triangle are one point but for rounding.
/// The rays pass it at an angle of at least 30 degrees.
#[test]
fn a_triangle_far_beside_a_ray_is_not_met() {
    let corners = [[0.0, 1.5, 3.0], [10.0, 0.0, 8.5], [1.0, 0.0, 0.0]];
    let [a, b, c] = corners.map(point);
    let triangle = Triangle::new(a, b, c).unwrap();
    let far = 9_007_199_254_740_992.0;
    for n in 0..100_000 {
        let random = PixelRandom::new(3, n, 0);
        let vector = |i| {
            let [x, y, z] = [i, i + 1, i + 2].map(|i| random.uniform(i) - 0.5);
            Vector3::new(x, y, z)
        };
        let (from, direction) = (vector(0) * far, vector(3));
        let angle = from.angle(direction);
        let ray = Ray::new(Point3::ORIGIN + from, direction).unwrap();
        if (FRAC_PI_6..=PI - FRAC_PI_6).contains(&angle) {
            assert_eq!(hit(&triangle, &ray), None, "{ray:?}");
        }
    }
}

#[test]
fn rays_in_its_plane_and_parallel_to_it_miss() {
    for zero in [0.0, -0.0] {
        for d in [[1.0, 0.0, zero], [zero, 1.0, zero], [1.0, -1.0, zero]] {
            for z in [0.0, -0.0, 0.5] {
                let ray = Ray::derived(point([-1.0, 2.0, z]), Vector3::from_glam(d.into()));
                assert_eq!(hit(&triangle(), &ray), None);
            }
        }
    }
}

#[test]
fn the_ends_of_the_interval_do_not_count() {
    let hit = |min, max| triangle().hit(&ahead(1.0, 1.0), Interval { min, max });
    assert!(hit(4_f64.next_down(), 4_f64.next_up()).is_some());
    assert!(hit(4.0, 9.0).is_none() && hit(0.0, 4.0).is_none());
    let leaving = Ray::derived(point([1.0, 1.0, 0.0]), Vector3::from(Z));
    assert!(triangle().hit(&leaving, Interval::AHEAD).is_none());
}

/// A power of two scales exactly; 1e100 is none, hence the tolerance.
#[test]
fn t_counts_in_lengths_of_the_direction() {
    for length in [1e-100, 0.5, 8.0, 1e100] {
        let d = Vector3::new(0.0, 0.0, -length);
        let found = hit(&triangle(), &Ray::derived(point([1.0, 0.5, 4.0]), d)).unwrap();
        assert_abs_diff_eq!(found.t * length, 4.0, epsilon = 8.0 * f64::EPSILON);
    }
}

/// Tolerance: two rounded products.
#[test]
fn tiny_and_huge_triangles_are_met_where_they_are() {
    for size in [1e-100, 1.0, 1e100] {
        let at = |x: f64, y: f64, z: f64| Point3::new(x * size, y * size, z * size);
        let sized = Triangle::new(at(0.0, 0.0, 0.0), at(1.0, 0.0, 0.0), at(0.0, 1.0, 0.0));
        let ray = Ray::derived(at(0.125, 0.25, 1.0), Vector3::new(0.0, 0.0, -1.0));
        let found = hit(&sized.unwrap(), &ray).unwrap();
        assert_abs_diff_eq!(found.t / size, 1.0, epsilon = 2.0 * f64::EPSILON);
        assert_eq!(found.face, Z);
    }
}

#[test]
fn a_ray_of_no_numbers_meets_nothing() {
    let (middle, down) = (point([1.0, 1.0, 4.0]), Vector3::new(0.0, 0.0, -1.0));
    for bad in [f64::NAN, f64::INFINITY] {
        let nowhere = Ray::derived(point([bad, 1.0, 4.0]), down);
        assert_eq!(hit(&triangle(), &nowhere), None);
        let anywhere = Ray::derived(middle, Vector3::new(0.0, bad, -1.0));
        assert_eq!(hit(&triangle(), &anywhere), None);
    }
    let still = Ray::derived(middle, Vector3::default());
    assert_eq!(hit(&triangle(), &still), None);
}
