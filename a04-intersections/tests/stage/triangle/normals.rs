//! Which way a triangle faces, and the normals between its corners.

use a02_math::{Direction, Normal3, Vector3};
use a04_intersections::{Hit, Triangle};
use approx::assert_abs_diff_eq;

use super::{Z, ahead, hit, point, triangle};

const X: Normal3 = Normal3::new(1.0, 0.0, 0.0);
const Y: Normal3 = Normal3::new(0.0, 1.0, 0.0);

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

/// Tolerance: rounding of the weights and of the length.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Three perpendicular normals: at a corner its own is seen, and elsewhere
/// their coordinates are the weights, brought to length 1.
#[test]
fn normals_are_weighted_means_of_those_at_the_corners() {
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
