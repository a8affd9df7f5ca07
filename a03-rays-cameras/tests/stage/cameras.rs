//! Cameras: the second course's relations, the formulas at places where their
//! value is known, and the arguments that a constructor must refuse. Odd and narrow
//! pictures, and gazes of all lengths, are among the extreme cases.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::{Basis, Camera, OrthographicCamera, PerspectiveCamera, PinholeCamera};
use approx::assert_abs_diff_eq;
use common::Size;
use testing::assert_refused;

const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);
const AHEAD: Vector3 = Vector3::new(0.0, 0.0, -1.0);
/// Rounding of a direction of length 1.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

fn size(width: u32, height: u32) -> Size {
    Size::new(width, height).unwrap()
}

fn unit(x: f64, y: f64, z: f64) -> Vector3 {
    Vector3::new(x, y, z).normalized().unwrap()
}

#[test]
fn second_course_relations_of_the_pinhole_camera() {
    let camera = PinholeCamera::new(Point3::ORIGIN, FRAC_PI_2).unwrap();
    for ((x, y), expected) in [
        ((0.0, 0.0), unit(-1.0, 1.0, -1.0)),
        ((5.0, 5.0), AHEAD),
        ((10.0, 10.0), unit(1.0, -1.0, -1.0)),
    ] {
        let ray = camera.generate_ray(size(10, 10), x, y);
        assert_abs_diff_eq!(ray.direction(), expected, epsilon = ROUNDING);
        assert_eq!(ray.origin(), Point3::ORIGIN);
    }
}

#[test]
fn pinhole_and_perspective_camera_agree() {
    let e = Point3::new(1.0, 2.0, 3.0);
    let pinhole = PinholeCamera::new(e, 1.1).unwrap();
    let perspective = PerspectiveCamera::new(e, AHEAD, UP, 1.1).unwrap();
    let size = size(64, 48);
    for (x, y) in [(0.0, 0.0), (63.0, 47.0), (10.25, 40.5), (-0.5, 47.5)] {
        let [a, b] = [pinhole.ray_for(size, x, y), perspective.ray_for(size, x, y)];
        assert_abs_diff_eq!(a.direction(), b.direction(), epsilon = ROUNDING);
        assert_eq!(a.origin(), b.origin());
    }
}

#[test]
fn the_middle_of_the_picture_looks_along_the_gaze() {
    let (e, g) = (Point3::new(3.0, 3.0, 3.0), Vector3::new(-3.0, -3.0, -3.0));
    let camera = PerspectiveCamera::new(e, g, UP, FRAC_PI_4).unwrap();
    let ray = camera.ray_for(size(640, 480), 319.5, 239.5);
    assert_eq!(ray.origin(), e);
    assert_abs_diff_eq!(ray.direction(), unit(-1.0, -1.0, -1.0), epsilon = ROUNDING);
}

#[test]
fn orthographic_rays_are_parallel_and_span_the_scale() {
    let e = Point3::new(1.0, 2.0, 3.0);
    let camera = OrthographicCamera::new(e, AHEAD * 7.0, UP, 3.0).unwrap();
    let size = size(640, 480);
    for (x, y, right, up) in [
        (0.0, 0.0, -2.0, -1.5),
        (639.0, 479.0, 2.0, 1.5),
        (319.5, 239.5, 0.0, 0.0),
    ] {
        let ray = camera.ray_for(size, x, y);
        assert_eq!(ray.direction(), AHEAD);
        assert_eq!(ray.origin(), e + Vector3::new(right, up, 0.0));
    }
}

#[test]
fn the_basis_is_right_handed_and_perpendicular() {
    for g in [
        AHEAD,
        Vector3::new(-3.0, -3.0, -3.0),
        Vector3::new(1e-9, 5.0, 1e-9),
    ] {
        let Basis { u, v, w, .. } = Basis::new(Point3::ORIGIN, g, UP).unwrap();
        assert_abs_diff_eq!(u.cross(v), w, epsilon = ROUNDING);
        assert_abs_diff_eq!(v.cross(w), u, epsilon = ROUNDING);
        assert_abs_diff_eq!(u.dot(u), 1.0, epsilon = ROUNDING);
        assert_abs_diff_eq!(v.dot(v), 1.0, epsilon = ROUNDING);
        assert!(v.dot(UP) > 0.0 && w.dot(g) < 0.0);
    }
}

#[test]
fn opening_angles_out_of_range_are_refused() {
    for angle in [0.0, -FRAC_PI_4, PI, 4.0, f64::NAN, f64::INFINITY, 1e-101] {
        let allowed = "from 1e-100 to less than pi";
        let pinhole = PinholeCamera::new(Point3::ORIGIN, angle);
        assert_refused(pinhole, "angle is", allowed);
        let perspective = PerspectiveCamera::new(Point3::ORIGIN, AHEAD, UP, angle);
        assert_refused(perspective, "angle is", allowed);
    }
}

#[test]
fn the_widest_and_the_narrowest_angle_still_give_rays() {
    for angle in [1e-100, PI - 1e-15] {
        let camera = PerspectiveCamera::new(Point3::ORIGIN, AHEAD, UP, angle).unwrap();
        for (x, y) in [(0.0, 0.0), (1.0, 1.0), (2.0, 1.0)] {
            let d = camera.ray_for(size(3, 3), x, y).direction();
            assert_abs_diff_eq!(d.dot(d), 1.0, epsilon = ROUNDING);
            assert!(d.z() < 0.0, "it looks ahead");
        }
    }
}

#[test]
fn bad_points_and_directions_are_refused_by_name() {
    let (nowhere, zero) = (Point3::new(0.0, f64::NAN, 0.0), Vector3::default());
    let diagonal = Vector3::new(1.0, 2.0, 3.0);
    for (e, g, t, name, allowed) in [
        (nowhere, AHEAD, UP, "eye point is", "from -1e100 to 1e100"),
        (
            Point3::ORIGIN,
            zero,
            UP,
            "gaze direction is",
            "not all of them 0",
        ),
        (
            Point3::ORIGIN,
            AHEAD,
            zero,
            "up vector is",
            "not all of them 0",
        ),
        (
            Point3::ORIGIN,
            -UP,
            UP,
            "up vector is",
            "not parallel to the gaze",
        ),
        (
            Point3::ORIGIN,
            UP + AHEAD * 1e-13,
            UP,
            "up vector is",
            "not parallel to the gaze",
        ),
        (
            Point3::ORIGIN,
            diagonal * 0.3,
            diagonal,
            "up vector is",
            "not parallel to the gaze",
        ),
    ] {
        assert_refused(Basis::new(e, g, t), name, allowed);
    }
    for s in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let camera = OrthographicCamera::new(Point3::ORIGIN, AHEAD, UP, s);
        assert_refused(camera, "scale s is", "from 1e-100 to 1e100");
    }
}
