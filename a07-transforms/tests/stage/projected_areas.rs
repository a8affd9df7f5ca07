//! How large a disc and an ellipsoid look without perspective: areas known in
//! closed form, from the camera to the picture.
//!
//! Along an outline whose half axes are at most a, a grid of samples at a
//! distance of h cuts about 8 a / h cells, and counts each wrongly by up to half
//! of it, as if at random: a standard deviation of sqrt(8 a / h / 12) h². The
//! tolerance is five deviations.

use std::f64::consts::PI;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{OrthographicCamera, render};
use a04_intersections::{Geometry, Sphere, World};
use a07_transforms::{Disc, Node, Transform};
use approx::assert_abs_diff_eq;
use common::{Color, Sampling, Settings, Size};

const PIXELS: u32 = 200;
const SAMPLES: u32 = 3;
const VIEW: f64 = 3.0;
/// The distance from the middle of the first pixel to the middle of the last is `VIEW`.
const PIXEL: f64 = VIEW / (PIXELS as f64 - 1.0);

fn tolerance(a: f64) -> f64 {
    let h = PIXEL / f64::from(SAMPLES);
    5.0 * (8.0 * a / h / 12.0).sqrt() * h * h
}

/// The area of a shape in the picture of a camera that looks along -z.
fn projected_area(shape: impl Geometry + 'static) -> f64 {
    let (e, g) = (Point3::new(0.0, 0.0, 9.0), Vector3::new(0.0, 0.0, -1.0));
    let camera = OrthographicCamera::new(e, g, Vector3::new(0.0, 1.0, 0.0), VIEW).unwrap();
    let world = World::new(Color::BLACK).unwrap().with(shape, Color::WHITE);
    let settings = Settings {
        size: Size::new(PIXELS, PIXELS).unwrap(),
        sampling: Sampling::Regular,
        samples: SAMPLES * SAMPLES,
        ..Settings::default()
    };
    let image = render(&camera, |ray| world.color_for(ray), &settings, &()).unwrap();
    image.pixels().iter().map(|color| color.r).sum::<f64>() * PIXEL * PIXEL
}

/// π r² |n · v|.
#[test]
fn a_disc_looks_smaller_aslant() {
    let (c, r) = (Point3::new(0.012_3, -0.027_1, 0.5), 1.3);
    for (x, y, z) in [
        (0.0, 0.0, 1.0),
        (0.3, 0.2, 1.0),
        (1.0, -0.7, -1.0),
        (-2.0, 1.0, 0.5),
    ] {
        let disc = Disc::new(c, Normal3::new(x, y, z), r).unwrap();
        let cosine = z.abs() / (x * x + y * y + z * z).sqrt();
        let expected = PI * r * r * cosine;
        assert_abs_diff_eq!(projected_area(disc), expected, epsilon = tolerance(r));
    }
}

/// An ellipsoid of half axes a, b, c, seen along v in its own directions, has
/// the area π sqrt((b c v.x)² + (a c v.y)² + (a b v.z)²).
#[test]
fn a_turned_ellipsoid_has_its_projected_area() {
    let [a, b, c] = [1.3, 0.3, 0.8];
    for (x, y) in [(0.0, 0.0), (0.5, 0.9), (1.2, -0.4), (-0.3, 1.5)] {
        // Turned about y first, and then about x.
        let transform = Transform::IDENTITY
            .translate(Point3::new(0.012_3, -0.027_1, 0.5))
            .and_then(|transform| transform.rotate_x(x))
            .and_then(|transform| transform.rotate_y(y))
            .and_then(|transform| transform.scale(a, b, c));
        let sphere = Sphere::new(Point3::ORIGIN, 1.0).unwrap();
        let ellipsoid = Node::new(transform.unwrap()).with(sphere);
        // The view direction (0, 0, 1), turned back: about x, then about y.
        let (vy, depth) = (libm::sin(x), libm::cos(x));
        let (vx, vz) = (-depth * libm::sin(y), depth * libm::cos(y));
        let [along_x, along_y, along_z] = [b * c * vx, a * c * vy, a * b * vz];
        let expected = PI * (along_x * along_x + along_y * along_y + along_z * along_z).sqrt();
        assert_abs_diff_eq!(projected_area(ellipsoid), expected, epsilon = tolerance(a));
    }
}
