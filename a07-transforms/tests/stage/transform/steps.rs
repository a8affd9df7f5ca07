//! The matrix of each step, and the order of steps.

use std::f64::consts::{FRAC_PI_2, PI};

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a07_transforms::{Mat4x4, Transform};
use approx::assert_abs_diff_eq;
use glam::{DMat4, DVec3};

use super::{ROUNDING, scaled, translated};

fn from_glam(matrix: DMat4) -> Mat4x4 {
    Mat4x4::from_rows(matrix.transpose().to_cols_array_2d())
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
