//! Triangles: their borders, both sides, normals, and corners that are refused.

mod in_plane;

use a02_math::{Direction, Normal3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{Hit, Triangle};
use approx::assert_abs_diff_eq;
use testing::assert_refused;

use super::support::{assert_hits, eighths, hit, point, ray};

const X: Normal3 = Normal3::new(1.0, 0.0, 0.0);
const Y: Normal3 = Normal3::new(0.0, 1.0, 0.0);
const Z: Normal3 = Normal3::new(0.0, 0.0, 1.0);
const TOWARDS: [f64; 3] = [0.0, 0.0, 1.0];
const AHEAD: [f64; 3] = [0.0, 0.0, -1.0];
/// Rounding of the weights and of the length of a normal.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// In the plane z = 0, counterclockwise seen from the front: its right angle at
/// the origin, and two legs of length 3.
const CORNERS: [[f64; 3]; 3] = [[0.0; 3], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0]];

fn triangle_of(corners: [[f64; 3]; 3]) -> Triangle {
    let [a, b, c] = corners.map(point);
    Triangle::new(a, b, c).unwrap()
}

fn triangle() -> Triangle {
    triangle_of(CORNERS)
}

/// From 4 in front of the place (`x`, `y`), straight ahead.
fn ahead(x: f64, y: f64) -> Ray {
    ray([x, y, 4.0], AHEAD)
}

#[test]
fn corners_and_edges_belong_to_it_and_both_sides_are_seen() {
    let (before, beyond) = (-5e-324, 3_f64.next_up());
    let [a, b, c] = CORNERS;
    for (triangle, normal) in [
        (triangle_of([a, b, c]), TOWARDS),
        (triangle_of([a, c, b]), AHEAD),
    ] {
        for (x, y) in [
            (1.0, 0.5),
            (0.0, 0.0),
            (3.0, 0.0),
            (0.0, 3.0),
            (1.5, 0.0),
            (0.0, 1.5),
            (1.5, 1.5),
            (0.75, 2.25),
        ] {
            assert_hits(
                &triangle,
                &[
                    ([x, y, 4.0], AHEAD, Some((4.0, normal))),
                    ([x, y, -2.0], TOWARDS, Some((2.0, normal))),
                    ([x, y, 4.0], TOWARDS, None),
                    ([x, y, 0.0], TOWARDS, None),
                ],
            );
        }
        for (x, y) in [
            (before, 1.0),
            (1.0, before),
            (beyond, 0.0),
            (0.0, beyond),
            (1.5, 1.5_f64.next_up()),
            (2.25, 0.75_f64.next_up()),
        ] {
            assert_hits(&triangle, &[([x, y, 4.0], AHEAD, None)]);
        }
    }
}

/// Points of eighths of edges of eighths are exact. Bound: each coordinate is below 32, so
/// that an area is off by 4 eps of 32², a weight by this over the determinant, and `t` and
/// the coordinates of the normal by the sum of three of them.
#[test]
fn triangles_in_any_position_are_hit_where_the_ray_aims() {
    let mut hits = 0;
    for n in 0..20_000 {
        let random = PixelRandom::new(9, n, 0);
        let [a, b, c, eye] = [0, 3, 6, 9].map(|first| eighths(random, first));
        let [beta, gamma] = [12, 13].map(|i| (4.0 * random.uniform(i)).floor() / 8.0 + 0.0625);
        let aim = a + (b - a) * beta + (c - a) * gamma;
        let ray = Ray::new(eye, aim - eye);
        let (Ok(triangle), Ok(ray)) = (Triangle::new(a, b, c), ray) else {
            continue;
        };
        let normals = [X, Y, Z];
        let triangle = triangle.with_normals(normals).unwrap();
        let determinant = (b - a).cross(c - a).dot(ray.direction()).abs();
        if determinant < 1e-3 {
            continue;
        }
        let found = hit(&triangle, &ray).unwrap_or_else(|| panic!("{triangle:?} {ray:?}"));
        let bound = 3.0 * 4.0 * f64::EPSILON * 32.0 * 32.0 / determinant;
        assert_abs_diff_eq!(found.t, (aim - eye).magnitude(), epsilon = 32.0 * bound);
        let mean = Normal3::new(1.0 - beta - gamma, beta, gamma);
        let normal = mean.unit("weights").unwrap();
        assert_abs_diff_eq!(found.normal, normal, epsilon = 3.0 * bound);
        hits += 1;
    }
    assert!(hits > 15_000, "{hits} hits");
}

/// With three perpendicular normals, the coordinates of the interpolated one are its
/// weights, brought to length 1; normals may have any length.
#[test]
fn normals_are_weighted_means_of_those_at_the_corners() {
    let curved = triangle()
        .with_normals([X * 1e-200, Y * 0.5, Z * 1e200])
        .unwrap();
    for ((x, y), weights) in [
        ((0.0, 0.0), [1.0, 0.0, 0.0]),
        ((3.0, 0.0), [0.0, 1.0, 0.0]),
        ((0.0, 3.0), [0.0, 0.0, 1.0]),
        // 3 - 1 - 0.5 = 1.5 parts of a, 1 of b, half a part of c.
        ((1.0, 0.5), [1.5, 1.0, 0.5]),
    ] {
        let found = hit(&curved, &ahead(x, y)).unwrap();
        let expected = Normal3::from_glam(weights.into()).unit("weights").unwrap();
        assert_abs_diff_eq!(found.normal, expected, epsilon = ROUNDING);
        assert_eq!(found.face, Z, "the light does not change it");
    }
    // Two equal normals leave the third its weight.
    let expected = Normal3::new(2.0, 0.0, 1.0).unit("weights").unwrap();
    for normals in [[X, X, Z], [Z, X, X]] {
        let curved = triangle().with_normals(normals).unwrap();
        let found = hit(&curved, &ahead(1.0, 1.0)).unwrap();
        assert_abs_diff_eq!(found.normal, expected, epsilon = ROUNDING);
    }
}

/// Their mean is exactly 0 half way between a and b.
#[test]
fn where_the_normals_cancel_the_face_gives_its_own() {
    let twisted = triangle().with_normals([X, -X, Z]).unwrap();
    assert_eq!(hit(&twisted, &ahead(1.5, 0.0)), Some(Hit::new(4.0, Z)));
    let beside = hit(&twisted, &ahead(0.75, 0.0)).unwrap();
    assert_eq!(beside.normal, X);
}

/// Normals within the face do not turn it.
#[test]
fn the_face_points_to_the_side_of_its_normals() {
    for (normals, expected) in [
        ([-Z; 3], -Z),
        ([-Z + X * 0.5, -Z + Y * 0.5, -Z], -Z),
        ([X; 3], Z),
    ] {
        let triangle = triangle().with_normals(normals).unwrap();
        let Hit { normal, face, .. } = hit(&triangle, &ahead(1.0, 1.0)).unwrap();
        assert_eq!(face, expected);
        assert!(normal.dot(face) >= 0.0);
    }
}

#[test]
fn thin_triangles_are_hit_and_rounding_errors_are_refused() {
    let limit = 4.0 * f64::EPSILON;
    let allowed = "three corners that are not on a line";
    for (height, is_accepted) in [
        (0.0, false),
        (limit, false),
        (limit.next_up(), true),
        (1e-12, true),
    ] {
        let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.5, height, 0.0]].map(point);
        for first in 0..3 {
            let [a, b, c] = [0, 1, 2].map(|i| corners[(first + i) % 3]);
            let triangle = Triangle::new(a, b, c);
            if is_accepted {
                let thin = triangle.unwrap();
                let found = hit(&thin, &ahead(0.5, 0.5 * height)).unwrap();
                assert_eq!(found.face, Z);
                assert_eq!(hit(&thin, &ahead(0.25, 0.8 * height)), None);
            } else {
                assert_refused(triangle, "triangle is", allowed);
            }
        }
    }
    let [a, b, _] = CORNERS.map(point);
    for twice in [[a, a, b], [a, b, a], [a, b, b], [b, b, b]] {
        let [a, b, c] = twice;
        assert_refused(Triangle::new(a, b, c), "triangle is", allowed);
    }
}

/// There the products of three lengths would lose digits, and with them `t`.
#[test]
fn triangles_too_small_for_the_formula_are_refused() {
    for size in [1e-101, 1e-110] {
        let [a, b, c] = CORNERS.map(|corner| point(corner.map(|x| x / 6.0 * size)));
        let allowed = "at least 1e-100 long";
        assert_refused(Triangle::new(a, b, c), "longest edge is", allowed);
    }
}
