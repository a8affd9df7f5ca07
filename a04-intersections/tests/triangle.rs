//! Triangles: their borders, their two sides, and their normals.

use std::f64::consts::{FRAC_PI_6, PI};

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{Geometry, Hit, Interval, Triangle};
use approx::assert_abs_diff_eq;

const X: Normal3 = Normal3::new(1.0, 0.0, 0.0);
const Y: Normal3 = Normal3::new(0.0, 1.0, 0.0);
const Z: Normal3 = Normal3::new(0.0, 0.0, 1.0);

fn point([x, y, z]: [f64; 3]) -> Point3 {
    Point3::new(x, y, z)
}

/// In the plane z = 0, counterclockwise seen from the front: its right angle at
/// the origin, and two legs of length 3.
fn triangle() -> Triangle {
    let [a, b, c] = [[0.0; 3], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0]].map(point);
    Triangle::new(a, b, c).unwrap()
}

/// From 4 in front of the place (`x`, `y`), straight ahead.
fn ahead(x: f64, y: f64) -> Ray {
    Ray::derived(point([x, y, 4.0]), Vector3::new(0.0, 0.0, -1.0))
}

fn hit(triangle: &Triangle, ray: &Ray) -> Option<Hit> {
    triangle.hit(ray, Interval::AHEAD)
}

#[test]
fn both_sides_are_seen_and_the_normal_stays() {
    assert_eq!(hit(&triangle(), &ahead(1.0, 0.5)), Some(Hit::new(4.0, Z)));
    let from_behind = Ray::derived(point([1.0, 0.5, -2.0]), Vector3::from(Z));
    assert_eq!(hit(&triangle(), &from_behind), Some(Hit::new(2.0, Z)));
    let away = Ray::derived(point([1.0, 0.5, 4.0]), Vector3::from(Z));
    assert_eq!(hit(&triangle(), &away), None);
}

#[test]
fn the_order_of_the_corners_says_where_the_face_points() {
    let [a, b, c] = [[0.0; 3], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0]].map(point);
    for (corners, face) in [
        ([a, b, c], Z),
        ([b, c, a], Z),
        ([c, a, b], Z),
        ([a, c, b], -Z),
        ([c, b, a], -Z),
    ] {
        let [a, b, c] = corners;
        let found = hit(&Triangle::new(a, b, c).unwrap(), &ahead(0.5, 0.25)).unwrap();
        assert_abs_diff_eq!(found.face, face, epsilon = f64::EPSILON);
        assert_eq!(found.t, 4.0);
    }
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

/// There the products of three lengths would lose digits, and with them t.
#[test]
fn triangles_too_small_for_the_formula_are_refused() {
    for size in [1e-101, 1e-107, 1e-110] {
        let [a, b, c] = [[0.0; 3], [0.5, 0.0, 0.0], [0.0, 0.5, 0.0]]
            .map(|corner| point(corner.map(|x: f64| x * size)));
        let said = Triangle::new(a, b, c).unwrap_err().to_string();
        assert!(said.starts_with("longest edge is"), "{said}");
    }
}

/// Tolerance: rounding of the weights and of the length.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Three perpendicular normals: at a corner its own is seen, and elsewhere
/// their coordinates are the weights, brought to length 1.
#[test]
fn normals_are_the_mean_of_the_corners_by_nearness_and_of_length_1() {
    let curved = triangle().with_normals([X, Y, Z]).unwrap();
    for ((x, y), weights) in [
        ((0.0, 0.0), [1.0, 0.0, 0.0]),
        ((3.0, 0.0), [0.0, 1.0, 0.0]),
        ((0.0, 3.0), [0.0, 0.0, 1.0]),
        ((1.0, 1.0), [1.0, 1.0, 1.0]),
        ((1.5, 0.0), [1.0, 1.0, 0.0]),
        ((1.5, 1.5), [0.0, 1.0, 1.0]),
        // 3 - 1 - 0.5 = 1.5 parts of a, 1 of b, half a part of c.
        ((1.0, 0.5), [1.5, 1.0, 0.5]),
    ] {
        let found = hit(&curved, &ahead(x, y)).unwrap();
        let expected = Vector3::from_glam(weights.into()).unit("weights").unwrap();
        assert_abs_diff_eq!(found.normal, expected.as_normal(), epsilon = ROUNDING);
        assert_eq!(found.face, Z, "which light does not change");
    }
    // Two of the same leave the third its weight.
    for (normals, weights) in [([X, X, Z], [2.0, 0.0, 1.0]), ([Z, X, X], [2.0, 0.0, 1.0])] {
        let curved = triangle().with_normals(normals).unwrap();
        let found = hit(&curved, &ahead(1.0, 1.0)).unwrap();
        let expected = Vector3::from_glam(weights.into()).unit("weights").unwrap();
        assert_abs_diff_eq!(found.normal, expected.as_normal(), epsilon = ROUNDING);
    }
}

#[test]
fn the_lengths_of_the_normals_do_not_matter() {
    let curved = triangle().with_normals([X, Y, Z]).unwrap();
    let stretched = triangle().with_normals([X * 1e-200, Y * 0.5, Z * 1e200]);
    assert_eq!(stretched.unwrap(), curved);
}

/// Their mean is exactly 0 half way between a and b.
#[test]
fn where_the_normals_cancel_out_the_face_has_its_own() {
    let twisted = triangle().with_normals([X, -X, Z]).unwrap();
    let found = hit(&twisted, &ahead(1.5, 0.0)).unwrap();
    assert_eq!(found, Hit::new(4.0, Z));
    let beside = hit(&twisted, &ahead(0.75, 0.0)).unwrap();
    assert_eq!(beside.normal, X);
}

#[test]
fn the_face_points_to_the_side_of_its_normals() {
    let turned = triangle().with_normals([-Z; 3]).unwrap();
    assert_eq!(
        hit(&turned, &ahead(1.0, 1.0)),
        Some(Hit::new(4.0, -Z)),
        "and not to where the corners run counterclockwise"
    );
    // Within the face they say nothing.
    let level = triangle().with_normals([X; 3]).unwrap();
    assert_eq!(hit(&level, &ahead(1.0, 1.0)).unwrap().face, Z);
    let leaning = [-Z + X * 0.5, -Z + Y * 0.5, -Z];
    let found = hit(&triangle().with_normals(leaning).unwrap(), &ahead(1.0, 1.0));
    let Hit { normal, face, .. } = found.unwrap();
    assert_eq!(face, -Z);
    assert!(normal.dot(face) > 0.9);
}

/// Whole numbers, so that the corners lie on a line exactly.
#[test]
fn corners_on_a_line_are_refused() {
    for n in 0..1000 {
        let random = PixelRandom::new(1, n, 0);
        let whole = |i| (random.uniform(i) * 2000.0 - 1000.0).round();
        let start = Point3::new(whole(0), whole(1), whole(2));
        let way = Vector3::new(whole(3), whole(4), 1.0);
        let at = |steps: f64| start + way * steps;
        let [b, c] = [5, 6].map(|i| (random.uniform(i) * 100.0).ceil());
        for [a, b, c] in [[0.0, b, -c], [b, 0.0, b + c], [0.0, 0.0, c], [b, c, b]] {
            let said = Triangle::new(at(a), at(b), at(c)).unwrap_err().to_string();
            assert!(said.starts_with("triangle is"), "{said}");
            assert!(said.contains("three corners that are not on a line"));
        }
    }
    let all_one = Triangle::new(Point3::ORIGIN, Point3::ORIGIN, Point3::ORIGIN);
    assert!(all_one.is_err());
}

#[test]
fn thin_triangles_are_none_the_less_triangles() {
    let [a, b, c] = [[0.0; 3], [1.0, 0.0, 0.0], [0.5, 1e-12, 0.0]].map(point);
    for [a, b, c] in [[a, b, c], [b, c, a], [c, a, b]] {
        let thin = Triangle::new(a, b, c).unwrap();
        let found = hit(&thin, &ahead(0.5, 5e-13)).unwrap();
        assert_eq!(found.face, Z);
        assert_eq!(hit(&thin, &ahead(0.5, 1.1e-12)), None);
    }
}

/// Thinner than rounding: refused in every order of the corners.
#[test]
fn it_does_not_matter_which_corner_comes_first() {
    let limit = 4.0 * f64::EPSILON;
    for (height, is_accepted) in [
        (1e-17, false),
        (limit, false),
        (limit.next_up(), true),
        (1e-14, true),
    ] {
        let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, height, 0.0]].map(point);
        for first in 0..3 {
            let [a, b, c] = [0, 1, 2].map(|i| corners[(first + i) % 3]);
            assert_eq!(Triangle::new(a, b, c).is_ok(), is_accepted, "{first}");
        }
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

#[test]
fn bad_corners_and_normals_are_refused_by_name() {
    let good = [[0.0; 3], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0]].map(point);
    for bad in [f64::NAN, f64::NEG_INFINITY, 1e101] {
        for (wrong, name) in ["corner a is", "corner b is", "corner c is"]
            .iter()
            .enumerate()
        {
            let mut corners = good;
            corners[wrong] = point([0.0, 0.0, bad]);
            let [a, b, c] = corners;
            let said = Triangle::new(a, b, c).unwrap_err().to_string();
            assert!(said.starts_with(name), "{said}");
            assert!(said.contains("from -1e100 to 1e100"), "{said}");
        }
    }
    for bad in [0.0, f64::NAN, f64::INFINITY] {
        for (wrong, name) in ["normal of a", "normal of b", "normal of c"]
            .iter()
            .enumerate()
        {
            let mut normals = [Z; 3];
            normals[wrong] = Normal3::new(bad, 0.0, 0.0);
            let said = triangle().with_normals(normals).unwrap_err().to_string();
            assert!(said.starts_with(name), "{said}");
            assert!(said.contains("not all of them 0"), "{said}");
        }
    }
}
