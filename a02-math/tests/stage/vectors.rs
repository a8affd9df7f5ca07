//! Laws of all vectors, also extremely long and short ones.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use a02_math::{Direction, Mat3x3, Point3, Vector3};
use approx::assert_abs_diff_eq;

/// Directions in every octant, along the axes, and of very unequal coordinates.
fn directions() -> Vec<Vector3> {
    let mut all = Vec::new();
    for x in [-3.0, 0.0, 0.25, 1e-9] {
        for y in [-1e-4, 0.0, 2.0] {
            for z in [-7.0, 0.0, 1.0] {
                all.push(Vector3::new(x, y, z));
            }
        }
    }
    all.retain(|v| *v != Vector3::default());
    all
}

/// Tolerance: three rounded quotients and a rounded root.
#[test]
fn any_length_can_be_normalized() {
    for exponent in [-900, -600, -500, -100, 0, 100, 500, 600, 1000] {
        for v in directions() {
            let stretched = Vector3::from_glam(v.to_glam().map(|x| libm::scalbn(x, exponent)));
            let unit = stretched.normalized().unwrap();
            assert_abs_diff_eq!(unit.magnitude(), 1.0, epsilon = 4.0 * f64::EPSILON);
            assert_abs_diff_eq!(unit, v.normalized().unwrap(), epsilon = 4.0 * f64::EPSILON);
        }
    }
    let denormal = Vector3::new(5e-324, 0.0, 0.0);
    assert_eq!(denormal.normalized(), Some(Vector3::new(1.0, 0.0, 0.0)));
    let longest = Vector3::new(f64::MAX, 0.0, -f64::MAX);
    let half = 0.5_f64.sqrt();
    let expected = Vector3::new(half, 0.0, -half);
    assert_abs_diff_eq!(
        longest.normalized().unwrap(),
        expected,
        epsilon = f64::EPSILON
    );
}

#[test]
fn vectors_without_a_direction_cannot_be_normalized() {
    for x in [0.0, -0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let vector = Vector3::new(0.0, x, 0.0);
        assert_eq!(vector.normalized(), None);
        assert_eq!(vector.as_normal().normalized(), None);
        for error in [
            vector.unit("gaze").unwrap_err().to_string(),
            vector.as_normal().unit("gaze").unwrap_err().to_string(),
        ] {
            assert!(
                error.starts_with("gaze is") && error.contains("not all of them 0"),
                "{error}"
            );
        }
    }
}

/// Tolerance: relative to the length.
#[test]
fn reflecting_twice_changes_nothing_and_once_keeps_the_length() {
    for v in directions() {
        for n in directions() {
            let n = n.as_normal().normalized().unwrap();
            let reflected = v.reflected_on(n);
            let rounding = 8.0 * f64::EPSILON * v.magnitude();
            assert_abs_diff_eq!(reflected.magnitude(), v.magnitude(), epsilon = rounding);
            assert_abs_diff_eq!(reflected.reflected_on(n), v, epsilon = rounding);
            assert_abs_diff_eq!(reflected.dot(n), v.dot(n), epsilon = rounding);
        }
    }
}

#[test]
fn tiny_and_straight_angles_are_exact() {
    let x = Vector3::new(1.0, 0.0, 0.0);
    for angle in [1e-5, 1e-8, 1e-12, 1e-150] {
        // For angles this small, the sine is the angle and the cosine 1.
        let turned = Vector3::new(libm::cos(angle), libm::sin(angle), 0.0);
        assert_abs_diff_eq!(x.angle(turned), angle, epsilon = 2.0 * f64::EPSILON * angle);
    }
    let long = Vector3::new(1.0, 1.0, 1.0);
    assert_eq!(long.angle(long), 0.0, "and no NaN");
    assert_eq!(long.angle(-long), PI);
    assert_eq!(x.angle(Vector3::new(0.0, -2.0, 0.0)), FRAC_PI_2);
    for length in [1e-300, 1e-100, 1e100, 1e300] {
        let slanted = Vector3::new(length, length, 0.0);
        assert_eq!((x * length).angle(slanted), FRAC_PI_4, "length {length}");
    }
}

/// Tolerance: rounding of the projection, relative to the vector.
#[test]
fn the_rest_of_a_projection_is_perpendicular() {
    assert_eq!(
        Vector3::new(1.0, 2.0, 3.0).projected_on(Vector3::default()),
        None
    );
    for a in directions() {
        for b in directions() {
            let rest = a - a.projected_on(b).unwrap();
            let scale = a.magnitude() * b.magnitude();
            assert_abs_diff_eq!(rest.dot(b), 0.0, epsilon = 4.0 * f64::EPSILON * scale);
        }
    }
}

#[test]
fn coordinates_out_of_range_are_refused() {
    assert_eq!(Point3::new(1.0, -5.0, 2.0).largest_coordinate(), 5.0);
    assert!(Point3::new(0.0, -1e100, 1e100).checked("eye").is_ok());
    for bad in [f64::NAN, f64::INFINITY, 1e101] {
        let error = Point3::new(0.0, bad, 0.0).checked("eye").unwrap_err();
        assert!(error.to_string().starts_with("eye is"), "{error}");
    }
}

#[test]
fn a_matrix_maps_the_axes_to_its_columns() {
    let m = Mat3x3::from_rows([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 10.0]]);
    assert_eq!(m * Vector3::new(1.0, 0.0, 0.0), Vector3::new(1.0, 4.0, 7.0));
    assert_eq!(m * Point3::new(0.0, 0.0, 1.0), Point3::new(3.0, 6.0, 10.0));
    assert_eq!(m.determinant(), -3.0);
}
