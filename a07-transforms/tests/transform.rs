//! Transforms: the steps, their order, their inverses, and normals.

use std::f64::consts::{FRAC_PI_2, PI};

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a07_transforms::{Mat4x4, Transform};
use approx::assert_abs_diff_eq;
use common::ArgumentError;
use glam::{DMat4, DVec3};

/// Rounding of a sine, a cosine and their products.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

fn from_glam(matrix: DMat4) -> Mat4x4 {
    Mat4x4::from_rows(matrix.transpose().to_cols_array_2d())
}

fn translated(x: f64, y: f64, z: f64) -> Transform {
    let to = Point3::new(x, y, z);
    Transform::IDENTITY.translate(to).unwrap()
}

fn scaled(x: f64, y: f64, z: f64) -> Transform {
    Transform::IDENTITY.scale(x, y, z).unwrap()
}

/// About the x, y or z axis.
fn rotate(transform: Transform, axis: u32, angle: f64) -> Transform {
    let step = [
        Transform::rotate_x,
        Transform::rotate_y,
        Transform::rotate_z,
    ];
    step[axis as usize](transform, angle).unwrap()
}

/// How far matrix times inverse, in either order, is from the identity.
fn assert_inverse(transform: &Transform, bound: f64) {
    let (m, i) = (transform.matrix(), transform.inverse());
    assert_abs_diff_eq!(m * i, Mat4x4::IDENTITY, epsilon = bound);
    assert_abs_diff_eq!(i * m, Mat4x4::IDENTITY, epsilon = bound);
}

#[test]
fn each_step_is_the_matrix_that_glam_makes() {
    let (x, y, z) = (1.5, -2.25, 0.75);
    let steps = [
        (
            translated(x, y, z),
            DMat4::from_translation(DVec3::new(x, y, z)),
        ),
        (scaled(x, y, z), DMat4::from_scale(DVec3::new(x, y, z))),
    ];
    for (transform, expected) in steps {
        assert_eq!(transform.matrix(), from_glam(expected));
        assert_inverse(&transform, f64::EPSILON);
    }
    for angle in [0.0, 1e-9, 0.5, -1.0, FRAC_PI_2, PI, 7.0, -100.0] {
        for (axis, expected) in [
            DMat4::from_rotation_x(angle),
            DMat4::from_rotation_y(angle),
            DMat4::from_rotation_z(angle),
        ]
        .into_iter()
        .enumerate()
        {
            let turned = rotate(Transform::IDENTITY, axis as u32, angle);
            assert_abs_diff_eq!(turned.matrix(), from_glam(expected), epsilon = ROUNDING);
            assert_inverse(&turned, ROUNDING);
        }
    }
}

/// From y towards z, from z towards x, from x towards y.
#[test]
fn turns_go_round_like_the_right_hand() {
    let axes = [
        Vector3::new(1.0, 0.0, 0.0),
        Vector3::new(0.0, 1.0, 0.0),
        Vector3::new(0.0, 0.0, 1.0),
    ];
    for axis in 0..3 {
        let [about, from, towards] = [0, 1, 2].map(|n| axes[(axis + n) % 3]);
        let turned = rotate(Transform::IDENTITY, axis as u32, FRAC_PI_2);
        assert_eq!(turned.matrix() * about, about);
        assert_abs_diff_eq!(turned.matrix() * from, towards, epsilon = ROUNDING);
        assert_abs_diff_eq!(turned.matrix() * towards, -from, epsilon = ROUNDING);
    }
}

#[test]
fn chained_calls_read_from_the_outside_inwards() {
    let x = Point3::new(1.0, 0.0, 0.0);
    // Turned to (0, 0, -1), and then moved.
    let moved_last = translated(1.0, 2.0, 3.0).rotate_y(FRAC_PI_2).unwrap();
    let expected = Point3::new(1.0, 2.0, 2.0);
    assert_abs_diff_eq!(moved_last.matrix() * x, expected, epsilon = ROUNDING);
    // Moved to (2, 2, 3), and then turned.
    let turned = Transform::IDENTITY.rotate_y(FRAC_PI_2).unwrap();
    let turned_last = turned.translate(Point3::new(1.0, 2.0, 3.0)).unwrap();
    let expected = Point3::new(3.0, 2.0, -2.0);
    assert_abs_diff_eq!(turned_last.matrix() * x, expected, epsilon = ROUNDING);
    // Doubled first, or last.
    let moved_last = translated(1.0, 0.0, 0.0).scale(2.0, 2.0, 2.0).unwrap();
    assert_eq!(moved_last.matrix() * x, Point3::new(3.0, 0.0, 0.0));
    assert_eq!(moved_last.inverse() * Point3::new(3.0, 0.0, 0.0), x);
}

#[test]
fn a_chain_is_the_product_of_its_steps() {
    let chain = translated(1.0, -2.0, 3.0)
        .rotate_x(0.3)
        .unwrap()
        .scale(2.0, 0.5, 4.0)
        .unwrap()
        .rotate_z(-1.2)
        .unwrap();
    let expected = DMat4::from_translation(DVec3::new(1.0, -2.0, 3.0))
        * DMat4::from_rotation_x(0.3)
        * DMat4::from_scale(DVec3::new(2.0, 0.5, 4.0))
        * DMat4::from_rotation_z(-1.2);
    assert_abs_diff_eq!(
        chain.matrix(),
        from_glam(expected),
        epsilon = 4.0 * ROUNDING
    );
    // glam's own inverse is good enough where nothing is stretched by much.
    let inverse = from_glam(expected.inverse());
    assert_abs_diff_eq!(chain.inverse(), inverse, epsilon = 16.0 * ROUNDING);
}

/// Bound: 4 eps for each step.
#[test]
fn long_chains_of_turns_can_be_undone() {
    for steps in [2, 10, 100, 10_000] {
        let turned = (0..steps).fold(Transform::IDENTITY, |transform, step| {
            rotate(transform, step % 3, 1.0 + 0.1 * f64::from(step % 10))
        });
        assert_inverse(&turned, f64::from(steps) * 4.0 * f64::EPSILON);
    }
}

#[test]
fn turning_a_moved_object_can_be_undone() {
    let transform = translated(1.0, 2.0, 3.0).rotate_y(FRAC_PI_2).unwrap();
    assert_inverse(&transform, ROUNDING);
    assert_inverse(&scaled(1e-8, 1.0, 1e8), 2.0 * f64::EPSILON);
}

/// Bound: 4 eps times the ratio of the greatest and the smallest stretch. The
/// inverse of the finished matrix would lose twice as many digits.
#[test]
fn strong_stretching_costs_digits_in_proportion() {
    for ratio in [1e2, 1e4, 1e8, 1e12] {
        let transform = Transform::IDENTITY
            .rotate_x(0.7)
            .and_then(|transform| transform.rotate_z(1.1))
            .and_then(|transform| transform.scale(ratio, 1.0, 1.0))
            .and_then(|transform| transform.rotate_y(0.4))
            .and_then(|transform| transform.rotate_z(-0.9));
        assert_inverse(&transform.unwrap(), 4.0 * f64::EPSILON * ratio);
    }
}

#[test]
fn a_ray_seen_from_the_object_keeps_its_t() {
    let transform = translated(1.0, 2.0, 4.0).scale(2.0, 4.0, 0.5).unwrap();
    let ray = Ray::derived(Point3::new(3.0, 2.0, 5.0), Vector3::new(0.0, 0.0, -1.0));
    let inside = transform.ray_to_object(&ray);
    assert_eq!(inside.origin(), Point3::new(1.0, 0.0, 2.0));
    assert_eq!(
        inside.direction(),
        Vector3::new(0.0, 0.0, -2.0),
        "of its own length"
    );
    for t in [0.5, 1.0, 7.0] {
        assert_eq!(transform.matrix() * inside.at(t), ray.at(t));
    }
}

fn unit(x: f64, y: f64, z: f64) -> Normal3 {
    Normal3::new(x, y, z).normalized().unwrap()
}

#[test]
fn normals_lean_away_from_where_the_object_is_stretched() {
    let diagonal = unit(1.0, 1.0, 0.0);
    for (transform, expected) in [
        (scaled(1.0, 0.5, 1.0), unit(1.0, 2.0, 0.0)),
        (scaled(1.0, 1e-8, 1.0), unit(1e-8, 1.0, 0.0)),
        (scaled(6.0, 1.0, 4.0), unit(1.0, 6.0, 0.0)),
        (scaled(2.0, 2.0, 2.0), diagonal),
        (scaled(1e-100, 1e-100, 1e-100), diagonal),
        (scaled(1e100, 1e100, 1e100), diagonal),
        (translated(5.0, -7.0, 9.0), diagonal),
        (scaled(-1.0, 1.0, 1.0), unit(-1.0, 1.0, 0.0)),
        (scaled(-2.0, -1.0, -1.0), unit(-1.0, -2.0, 0.0)),
    ] {
        let normal = transform.normal_from_object(diagonal).unwrap();
        assert_abs_diff_eq!(normal, expected, epsilon = ROUNDING);
    }
}

/// Of a moved, turned and stretched object. Bound: 8 eps of the length of the
/// tangent, times the ratio of the stretches, for the normal is only as long
/// as its least stretched part.
#[test]
fn normals_stay_perpendicular_to_the_surface_and_of_length_1() {
    for n in 0..2000 {
        let random = PixelRandom::new(16, n, 0);
        let any = |i: u64| 4.0 * random.uniform(i) - 2.0;
        let stretch = [0, 1, 2].map(|i| {
            let factor = 0.1 + 9.9 * random.uniform(i);
            if random.uniform(i + 3) < 0.3 {
                -factor
            } else {
                factor
            }
        });
        let [sx, sy, sz] = stretch;
        let transform = translated(any(6), any(7), any(8))
            .rotate_x(any(9))
            .and_then(|transform| transform.scale(sx, sy, sz))
            .and_then(|transform| transform.rotate_y(any(10)))
            .unwrap();
        let normal = unit(any(11), any(12), any(13));
        let tangent = Vector3::new(any(14), any(15), any(16)).cross(normal.into());
        let moved = transform.matrix() * tangent;
        let turned = transform.normal_from_object(normal).unwrap();
        let bound = 8.0 * f64::EPSILON * 100.0 * moved.magnitude();
        assert_abs_diff_eq!(turned.dot(moved), 0.0, epsilon = bound);
        assert_abs_diff_eq!(turned.dot(turned), 1.0, epsilon = ROUNDING);
        // What is outside stays outside.
        let outwards = transform.matrix() * Vector3::from(normal);
        assert!(turned.dot(outwards) > 0.0);
    }
}

#[test]
fn what_has_no_direction_has_no_normal() {
    let transform = scaled(1.0, 2.0, 3.0);
    assert_eq!(transform.normal_from_object(Normal3::default()), None);
    let nan = Normal3::new(f64::NAN, 0.0, 0.0);
    assert_eq!(transform.normal_from_object(nan), None);
}

fn refusal(transform: Result<Transform, ArgumentError>) -> String {
    transform.unwrap_err().to_string()
}

#[test]
fn bad_steps_are_refused_by_name() {
    let start = Transform::IDENTITY;
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for said in [
            start.rotate_x(bad),
            start.rotate_y(bad),
            start.rotate_z(bad),
        ]
        .map(refusal)
        {
            assert!(said.starts_with("angle is"), "{said}");
            assert!(said.contains("a finite number"), "{said}");
        }
    }
    for bad in [f64::NAN, f64::INFINITY, -1e101] {
        let said = refusal(start.translate(Point3::new(0.0, bad, 0.0)));
        assert!(said.starts_with("translation is"), "{said}");
        assert!(said.contains("from -1e100 to 1e100"), "{said}");
    }
}

/// Flat objects have lost a coordinate, and no inverse gives it back.
#[test]
fn scales_of_nothing_and_beyond_the_allowed_range_are_refused_by_name() {
    let start = Transform::IDENTITY;
    for bad in [0.0, -0.0, f64::NAN, f64::INFINITY, 1e-101, -1e-101, 1e101] {
        for (scale, name) in [
            (start.scale(bad, 1.0, 1.0), "scale x is"),
            (start.scale(1.0, bad, 1.0), "scale y is"),
            (start.scale(1.0, 1.0, bad), "scale z is"),
        ] {
            let said = refusal(scale);
            assert!(said.starts_with(name), "{said}");
            assert!(said.contains("magnitude is from 1e-100 to 1e100"), "{said}");
        }
    }
    for good in [1e-100, -1e-100, 1e100, -1e100] {
        assert!(start.scale(good, good, good).is_ok());
    }
}

#[test]
fn chains_too_large_for_numbers_are_refused() {
    for factor in [1e100, 1e-100] {
        let scale = |transform: Transform| transform.scale(factor, factor, factor);
        let said = refusal(scale(Transform::IDENTITY).and_then(scale));
        assert!(said.starts_with("transform is too large"), "{said}");
        assert!(said.contains("no number above 1e150"), "{said}");
    }
}
