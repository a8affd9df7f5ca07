//! Laws of all vectors, also extremely long and short ones.

use a02_math::{Direction, Point3, Vector3};
use approx::assert_abs_diff_eq;
use testing::assert_refused;

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
    let longest = Vector3::new(f64::MAX, 0.0, -f64::MAX);
    let expected = Vector3::new(1.0, 0.0, -1.0) * 0.5_f64.sqrt();
    let unit = longest.normalized().unwrap();
    assert_abs_diff_eq!(unit, expected, epsilon = f64::EPSILON);
}

#[test]
fn vectors_without_a_direction_cannot_be_normalized() {
    for x in [0.0, -0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let vector = Vector3::new(0.0, x, 0.0);
        assert_eq!(vector.normalized(), None);
        assert_eq!(vector.as_normal().normalized(), None);
        let allowed = "not all of them 0";
        assert_refused(vector.unit("gaze"), "gaze is", allowed);
        assert_refused(vector.as_normal().unit("gaze"), "gaze is", allowed);
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

/// Tolerance: rounding of the projection, relative to the vector.
#[test]
fn the_rest_of_a_projection_is_perpendicular() {
    let zero = Vector3::default();
    assert_eq!(Vector3::new(1.0, 2.0, 3.0).projected_on(zero), None);
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
        let eye = Point3::new(0.0, bad, 0.0).checked("eye");
        assert_refused(eye, "eye is", "from -1e100 to 1e100");
    }
}
