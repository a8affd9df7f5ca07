//! Cameras: the formulas at places where their value is known, and the arguments that a
//! constructor must refuse. The second course's relations, odd and narrow pictures, and gazes
//! of all lengths are among the extreme cases.

use std::f64::consts::{FRAC_PI_4, PI};

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::{Basis, Camera, OrthographicCamera, PerspectiveCamera, PinholeCamera};
use approx::assert_abs_diff_eq;
use common::Size;
use testing::assert_refused;

const O: Point3 = Point3::ORIGIN;
const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);
const AHEAD: Vector3 = Vector3::new(0.0, 0.0, -1.0);
/// Rounding of a direction of length 1.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

fn size(width: u32, height: u32) -> Size {
    Size::new(width, height).unwrap()
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
fn the_widest_and_the_narrowest_angle_still_give_rays() {
    for angle in [1e-100, PI - 1e-15] {
        let camera = PerspectiveCamera::new(O, AHEAD, UP, angle).unwrap();
        for (x, y) in [(0.0, 0.0), (1.0, 1.0), (2.0, 1.0)] {
            let d = camera.ray_for(size(3, 3), x, y).direction();
            assert_abs_diff_eq!(d.dot(d), 1.0, epsilon = ROUNDING);
            assert!(d.z() < 0.0, "it looks ahead");
        }
    }
}

#[test]
fn bad_arguments_are_refused_by_name() {
    let (nowhere, zero) = (Point3::new(0.0, f64::NAN, 0.0), Vector3::default());
    let diagonal = Vector3::new(1.0, 2.0, 3.0);
    for (e, g, t, name, allowed) in [
        (nowhere, AHEAD, UP, "eye point is", "from -1e100 to 1e100"),
        (O, zero, UP, "gaze direction is", "not all of them 0"),
        (O, AHEAD, zero, "up vector is", "not all of them 0"),
    ] {
        assert_refused(Basis::new(e, g, t), name, allowed);
    }
    for (g, t) in [
        (-UP, UP),
        (UP + AHEAD * 1e-13, UP),
        (diagonal * 0.3, diagonal),
    ] {
        let basis = Basis::new(O, g, t);
        assert_refused(basis, "up vector is", "not parallel to the gaze");
    }
    for angle in [0.0, -FRAC_PI_4, PI, 4.0, f64::NAN, f64::INFINITY, 1e-101] {
        let allowed = "from 1e-100 to less than pi";
        assert_refused(PinholeCamera::new(O, angle), "angle is", allowed);
        let perspective = PerspectiveCamera::new(O, AHEAD, UP, angle);
        assert_refused(perspective, "angle is", allowed);
    }
    for s in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let camera = OrthographicCamera::new(O, AHEAD, UP, s);
        assert_refused(camera, "scale s is", "from 1e-100 to 1e100");
    }
}
