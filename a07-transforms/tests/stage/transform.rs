//! Transforms: each step, normals, and refusals. That the inverse of a chain undoes its
//! steps is shown by the extreme cases G01 to G06; the order of the steps, and rays in the
//! space of the object, by the exercises `chain` and `under_transform`.

use std::f64::consts::{FRAC_PI_2, PI};

use a02_math::{Normal3, Point3, Vector3};
use a07_transforms::Transform;
use approx::assert_abs_diff_eq;
use common::ArgumentError;
use testing::assert_refused;

use super::support::point;

/// Rounding of a sine, a cosine and their products.
const ROUNDING: f64 = 4.0 * f64::EPSILON;
const START: Transform = Transform::IDENTITY;

/// A step of a transform.
#[derive(Clone, Copy, Debug)]
enum Step {
    Translate(f64, f64, f64),
    Scale(f64, f64, f64),
    /// About the x, y or z axis.
    Rotate(usize, f64),
}
use Step::{Rotate, Scale, Translate};

impl Step {
    fn after(self, transform: Transform) -> Result<Transform, ArgumentError> {
        match self {
            Translate(x, y, z) => transform.translate(Point3::new(x, y, z)),
            Scale(x, y, z) => transform.scale(x, y, z),
            Rotate(0, angle) => transform.rotate_x(angle),
            Rotate(1, angle) => transform.rotate_y(angle),
            Rotate(_, angle) => transform.rotate_z(angle),
        }
    }
}

fn chain(steps: &[Step]) -> Transform {
    let chained = steps
        .iter()
        .try_fold(START, |chain, step| step.after(chain));
    chained.unwrap()
}

/// Rotations from y towards z, from z towards x, from x towards y.
#[test]
fn each_step_moves_points_as_its_name_says() {
    let p = Point3::new(1.0, 2.0, 3.0);
    for (step, expected) in [
        (Translate(1.5, -2.25, 0.75), [2.5, -0.25, 3.75]),
        (Scale(1.5, -2.25, 0.75), [1.5, -4.5, 2.25]),
    ] {
        let transform = chain(&[step]);
        assert_eq!(transform.matrix() * p, point(expected));
        assert_eq!(transform.inverse() * point(expected), p);
    }
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for angle in [0.0, 1e-9, 0.5, -1.0, FRAC_PI_2, PI, 7.0, -100.0] {
        for axis in 0..3 {
            let [about, from, towards] =
                [0, 1, 2].map(|n| Vector3::from_glam(axes[(axis + n) % 3].into()));
            let matrix = chain(&[Rotate(axis, angle)]).matrix();
            let (sin, cos) = (libm::sin(angle), libm::cos(angle));
            assert_eq!(matrix * about, about);
            let turned = from * cos + towards * sin;
            assert_abs_diff_eq!(matrix * from, turned, epsilon = ROUNDING);
            let turned = towards * cos - from * sin;
            assert_abs_diff_eq!(matrix * towards, turned, epsilon = ROUNDING);
        }
    }
}

fn unit(x: f64, y: f64, z: f64) -> Normal3 {
    Normal3::new(x, y, z).normalized().unwrap()
}

#[test]
fn normals_lean_away_from_the_axis_of_stretching() {
    let diagonal = unit(1.0, 1.0, 0.0);
    for (step, expected) in [
        (Scale(1.0, 0.5, 1.0), unit(1.0, 2.0, 0.0)),
        (Scale(1e-100, 1e-100, 1e-100), diagonal),
        (Scale(1e100, 1e100, 1e100), diagonal),
        (Translate(5.0, -7.0, 9.0), diagonal),
        (Scale(-2.0, -1.0, -1.0), unit(-1.0, -2.0, 0.0)),
    ] {
        let normal = chain(&[step]).normal_from_object(diagonal).unwrap();
        assert_abs_diff_eq!(normal, expected, epsilon = ROUNDING);
    }
    for no_direction in [Normal3::default(), Normal3::new(f64::NAN, 0.0, 0.0)] {
        let transform = chain(&[Scale(1.0, 2.0, 3.0)]);
        assert_eq!(transform.normal_from_object(no_direction), None);
    }
}

#[test]
fn bad_steps_are_refused_by_name() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for axis in 0..3 {
            let turned = Rotate(axis, bad).after(START);
            assert_refused(turned, "angle is", "a finite number");
        }
        let translation = Translate(0.0, bad, 0.0).after(START);
        assert_refused(translation, "translation is", "from -1e100 to 1e100");
    }
    for bad in [0.0, -0.0, f64::NAN, f64::INFINITY, 1e-101, -1e-101, 1e101] {
        for (scale, name) in [
            (Scale(bad, 1.0, 1.0), "scale x is"),
            (Scale(1.0, bad, 1.0), "scale y is"),
            (Scale(1.0, 1.0, bad), "scale z is"),
        ] {
            let allowed = "magnitude is from 1e-100 to 1e100";
            assert_refused(scale.after(START), name, allowed);
        }
    }
    for factor in [1e100, 1e-100, -1e-100] {
        let scale = Scale(factor, factor, factor);
        let twice = scale.after(chain(&[scale]));
        assert_refused(twice, "transform is too large", "no number above 1e150");
    }
}
