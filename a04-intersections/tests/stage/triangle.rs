//! Triangles: their borders, both sides, normals, rays in their plane, and corners that are
//! refused.

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Hit, Triangle};
use approx::assert_abs_diff_eq;
use testing::{Random, assert_refused};

use crate::test_shapes::{assert_hits, eighths, hit, point, ray};

const X: Normal3 = Normal3::new(1.0, 0.0, 0.0);
const Y: Normal3 = Normal3::new(0.0, 1.0, 0.0);
const Z: Normal3 = Normal3::new(0.0, 0.0, 1.0);
const TOWARDS: [f64; 3] = [0.0, 0.0, 1.0];
const AHEAD: [f64; 3] = [0.0, 0.0, -1.0];

/// In the plane z = 0, counterclockwise seen from the front: its right angle at
/// the origin, and two legs of length 3.
const CORNERS: [[f64; 3]; 3] = [[0.0; 3], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0]];

fn triangle_of(corners: [[f64; 3]; 3]) -> Triangle {
    let [a, b, c] = corners.map(point);
    Triangle::new(a, b, c).unwrap()
}

#[test]
fn corners_and_edges_belong_to_it_and_both_sides_are_seen() {
    let [a, b, c] = CORNERS;
    for (corners, normal) in [([a, b, c], TOWARDS), ([a, c, b], AHEAD)] {
        let triangle = triangle_of(corners);
        for (i, j) in (0..5).flat_map(|i| (0..5 - i).map(move |j| (i, j))) {
            let [x, y] = [i, j].map(|n| 0.75 * f64::from(n));
            assert_hits(
                &triangle,
                &[
                    ([x, y, 4.0], AHEAD, Some((4.0, normal))),
                    ([x, y, -2.0], TOWARDS, Some((2.0, normal))),
                    ([x, y, 4.0], TOWARDS, None),
                    ([x, y, 0.0], TOWARDS, None),
                    ([x, -5e-324, 4.0], AHEAD, None),
                    ([-5e-324, y, 4.0], AHEAD, None),
                    ([x, (3.0 - x).next_up(), 4.0], AHEAD, None),
                ],
            );
        }
    }
}

/// A triangle of eighths, exact.
fn any_triangle(random: &mut Random) -> ([Point3; 3], Triangle) {
    let mut triangles = std::iter::repeat_with(|| {
        let [a, b, c] = [(); 3].map(|()| eighths(random));
        Some(([a, b, c], Triangle::new(a, b, c).ok()?))
    });
    triangles.find_map(|triangle| triangle).unwrap()
}

/// Points of eighths of edges of eighths are exact. Bound: each coordinate is below 32, so
/// that an area is off by 4 eps of 32², a weight by this over the determinant, and `t` and
/// the coordinates of the normal by the sum of three of them. Normals may have any length, and
/// some corners have the same.
#[test]
fn triangles_in_any_position_are_hit_where_the_ray_aims() {
    let mut hits = 0;
    for n in 0..20_000 {
        let random = &mut Random::new(n);
        let ([a, b, c], triangle) = any_triangle(random);
        let eye = eighths(random);
        let [beta, gamma] = [(); 2].map(|()| f64::from(random.below(4)) / 8.0 + 0.0625);
        let to_aim = a + (b - a) * beta + (c - a) * gamma - eye;
        let across = (b - a).cross(c - a);
        let Ok(ray) = Ray::new(eye, to_aim) else {
            continue;
        };
        let determinant = across.dot(ray.direction()).abs();
        if determinant < 1e-3 {
            continue;
        }
        let normals = [[X, Y, Z], [X, X, Z], [Z, X, X], [-Y; 3]][n as usize % 4];
        let [na, nb, nc] = normals;
        let smooth = triangle.with_normals([na * 1e-200, nb * 0.5, nc * 1e200]);
        let found = hit(&smooth.unwrap(), &ray).unwrap_or_else(|| panic!("{triangle:?} {ray:?}"));
        let bound = 3.0 * 4.0 * f64::EPSILON * 32.0 * 32.0 / determinant;
        assert_abs_diff_eq!(found.t, to_aim.magnitude(), epsilon = 32.0 * bound);
        let mean = na * (1.0 - beta - gamma) + nb * beta + nc * gamma;
        let normal = mean.unit("weights").unwrap();
        assert_abs_diff_eq!(found.normal, normal, epsilon = 3.0 * bound);
        // The face is perpendicular to the edges, on the side of the normals.
        assert!(found.geometric_normal.dot(na + nb + nc) >= -bound);
        let face = across.as_normal().unit("face").unwrap();
        let turned = face * found.geometric_normal.dot(face).signum();
        assert_abs_diff_eq!(found.geometric_normal, turned, epsilon = bound);
        hits += 1;
    }
    assert!(hits > 15_000, "{hits} hits");
}

/// The mean is exactly 0 half way between a and b. Normals within the face do not turn it.
#[test]
fn where_the_normals_cancel_the_face_gives_its_own() {
    for (normals, x, expected) in [
        ([X, -X, Z], 1.5, Z),
        ([X, -X, Z], 0.75, X),
        ([X; 3], 1.0, X),
    ] {
        let twisted = triangle_of(CORNERS).with_normals(normals).unwrap();
        let Hit {
            normal,
            geometric_normal,
            ..
        } = hit(&twisted, &ray([x, 0.0, 4.0], AHEAD)).unwrap();
        assert_eq!((normal, geometric_normal), (expected, Z));
    }
}

#[test]
fn thin_triangles_are_hit_and_rounding_errors_are_refused() {
    let limit = 4.0 * f64::EPSILON;
    let allowed = "three corners that are not on a line";
    for height in [0.0, limit, limit.next_up(), 1e-12] {
        let mut corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.5, height, 0.0]];
        for _ in 0..3 {
            corners.rotate_left(1);
            if height > limit {
                let thin = triangle_of(corners);
                let ahead = |x, y| hit(&thin, &ray([x, y, 4.0], AHEAD));
                assert_eq!(ahead(0.5, 0.5 * height).unwrap().geometric_normal, Z);
                assert_eq!(ahead(0.25, 0.8 * height), None);
            } else {
                let [a, b, c] = corners.map(point);
                assert_refused(Triangle::new(a, b, c), "triangle is", allowed);
            }
        }
    }
    let [a, b, _] = CORNERS.map(point);
    for [a, b, c] in [[a, a, b], [a, b, a], [a, b, b], [b, b, b]] {
        assert_refused(Triangle::new(a, b, c), "triangle is", allowed);
    }
}

/// Whether the corners (0, 0), (1, 0) and (0, 1), which are (0, 0), (4, 0) and (0, 4) in
/// quarters, lie on one side of the line through two places.
fn passes_beside([px, py]: [i32; 2], [qx, qy]: [i32; 2]) -> bool {
    let side = |x: i32, y: i32| ((qx - px) * (y - py) - (qy - py) * (x - px)).signum();
    let sides = [side(0, 0), side(4, 0), side(0, 4)];
    sides == [1; 3] || sides == [-1; 3]
}

/// A place of the plane, in quarters of two edges, is a multiple of 1/32 of each
/// coordinate: all points are exact, and only the direction of the ray is rounded.
#[test]
fn rays_in_the_plane_beside_a_triangle_miss_it() {
    for n in 0..10_000 {
        let random = &mut Random::new(n);
        let ([a, b, c], triangle) = any_triangle(random);
        for _ in 0..50 {
            let [p, q] = [(); 2].map(|()| [(); 2].map(|()| random.below(33) as i32 - 16));
            if passes_beside(p, q) {
                let [p, q] = [p, q]
                    .map(|[x, y]| a + ((b - a) * f64::from(x) + (c - a) * f64::from(y)) * 0.25);
                let ray = Ray::new(p, q - p).unwrap();
                assert_eq!(hit(&triangle, &ray), None, "{triangle:?} {ray:?}");
            }
        }
    }
}

/// Seen along its plane a triangle has no area, so that a ray may hit or miss it. A ray
/// along an edge hits nothing but the edge, and one through a corner nothing before or
/// behind all corners, to the rounding of depths below 64.
#[test]
fn rays_in_the_plane_hit_edges_and_corners_where_they_are() {
    const ROUNDING: f64 = 64.0 * 16.0 * f64::EPSILON;
    let (mut along_edges, mut through_corners) = (0, 0);
    for n in 0..20_000 {
        let random = &mut Random::new(n);
        let ([a, b, c], triangle) = any_triangle(random);
        let fraction = (f64::from(random.below(33)) - 16.0) / 4.0;
        for (from, to, third) in [(a, b, c), (b, c, a), (c, a, b)] {
            let along: Vector3 = to - from;
            let aside = along + (third - from) * fraction;
            for (hits, way, last) in [
                (&mut along_edges, along, to),
                (&mut through_corners, aside, third),
            ] {
                let eye = from - way * 0.5;
                let Ok(ray) = Ray::new(eye, way) else {
                    continue;
                };
                let Some(Hit { t, .. }) = hit(&triangle, &ray) else {
                    continue;
                };
                let mut depths = [from, to, last].map(|p| (p - eye).dot(ray.direction()));
                depths.sort_by(f64::total_cmp);
                let range = depths[0] - ROUNDING..=depths[2] + ROUNDING;
                assert!(range.contains(&t), "{triangle:?} {ray:?}");
                *hits += 1;
            }
        }
    }
    assert!(
        along_edges > 1000 && through_corners > 1000,
        "both are tested"
    );
}
