//! The camera that a person rotates.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use a02_math::{Point3, Vector3};
use a03_rays_cameras::instruments::orbit_camera::{Orbit, OrbitCamera};
use a03_rays_cameras::{Camera, OrthographicCamera, PerspectiveCamera};
use common::Size;

const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);

/// A camera at (0, 0, 4) that looks at the origin: rotated by a quarter, it looks from the
/// side, half the zoom from half as far, and the gaze stays below the vertical, by at most 1.5 from the
/// horizontal.
#[test]
fn a_camera_turns_around_the_centre() {
    let gaze = |yaw, pitch, zoom| {
        let (e, g) = (Point3::new(0.0, 0.0, 4.0), Vector3::new(0.0, 0.0, -1.0));
        let camera = PerspectiveCamera::new(e, g, UP, FRAC_PI_4).unwrap();
        let (size, orbit) = (Size::new(3, 3).unwrap(), Orbit { yaw, pitch, zoom });
        OrbitCamera::new(Box::new(camera), size, Point3::ORIGIN, orbit).ray_for(size, 1.0, 1.0)
    };
    let ray = gaze(FRAC_PI_2, 0.0, 0.5);
    let far = |v: Vector3, x| (v - Vector3::new(x, 0.0, 0.0)).magnitude();
    assert!(far(ray.origin() - Point3::ORIGIN, 2.0) < 1e-15);
    assert!(far(ray.direction(), -1.0) < 1e-15);
    for pitch in [2.0, -2.0] {
        let y = gaze(0.0, pitch, 1.0).direction().y();
        assert!((y - libm::sin(1.5_f64.copysign(pitch))).abs() < 1e-15);
    }
}

/// One that looks straight down still does when it is moved nearer, and is rotated up as any other.
#[test]
fn a_gaze_that_is_vertical_stays_vertical() {
    let gaze = |pitch| {
        let (e, g) = (Point3::new(0.0, 4.0, 0.0), Vector3::new(0.0, -1.0, 0.0));
        let up = Vector3::new(0.0, 0.0, -1.0);
        let camera = PerspectiveCamera::new(e, g, up, FRAC_PI_4).unwrap();
        let (yaw, zoom) = (0.0, 0.9);
        let (size, orbit) = (Size::new(3, 3).unwrap(), Orbit { yaw, pitch, zoom });
        let camera = OrbitCamera::new(Box::new(camera), size, Point3::ORIGIN, orbit).simplified();
        camera.ray_for(size, 1.0, 1.0).direction()
    };
    for pitch in [0.0, -0.5] {
        assert_eq!(gaze(pitch), Vector3::new(0.0, -1.0, 0.0), "{pitch}");
    }
    assert!((gaze(0.5).y() + libm::cos(0.5)).abs() < 1e-15);
}

/// It has the same rays, up to rounding.
#[test]
fn a_rotated_camera_of_a_known_type_is_one_of_this_type() {
    let (e, g) = (Point3::new(3.0, 2.0, 4.0), Vector3::new(-3.0, -1.5, -4.0));
    let camera = |is_perspective| -> Box<dyn Camera> {
        if is_perspective {
            Box::new(PerspectiveCamera::new(e, g, UP, FRAC_PI_4).unwrap())
        } else {
            Box::new(OrthographicCamera::new(e, g, UP, 5.0).unwrap())
        }
    };
    let size = Size::new(7, 5).unwrap();
    let orbit = Orbit {
        yaw: 0.7,
        pitch: 0.2,
        zoom: 0.5,
    };
    let centre = Point3::new(0.5, 0.0, 0.0);
    for is_perspective in [true, false] {
        let rotated = || OrbitCamera::new(camera(is_perspective), size, centre, orbit);
        let (asked, simplified) = (rotated(), rotated().simplified());
        for (x, y) in [(0.0, 0.0), (3.0, 2.0), (6.5, 1.25)] {
            let [a, b] = [asked.ray_for(size, x, y), simplified.ray_for(size, x, y)];
            assert!((a.origin() - b.origin()).magnitude() < 1e-14);
            assert!((a.direction() - b.direction()).magnitude() < 1e-14);
        }
    }
}
