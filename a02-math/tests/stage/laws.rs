//! Laws of all vectors and matrices, also of extremely long and short vectors.
//!
//! The same cases come every time; `PROPTEST_CASES=100000` makes more of them.

use a02_math::{Direction, Mat3x3, Point3, Vector3};
use approx::assert_abs_diff_eq;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use testing::assert_refused;

fn config() -> ProptestConfig {
    ProptestConfig {
        // A failure is printed, and repeats without a file that records it.
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(0),
        ..ProptestConfig::default()
    }
}

/// Of either sign, up to 2^30 and down to 2^-30 and 0.
fn number() -> impl Strategy<Value = f64> {
    let numbers = (-1.0..1.0, -30..=30).prop_map(|(x, exponent)| libm::scalbn(x, exponent));
    prop_oneof![9 => numbers, 1 => Just(0.0)]
}

/// So small that products of six of them, and sums of these, are exact.
fn whole() -> impl Strategy<Value = f64> {
    (-100..=100).prop_map(f64::from)
}

fn vector(number: impl Strategy<Value = f64>) -> impl Strategy<Value = Vector3> {
    prop::array::uniform3(number).prop_map(|[x, y, z]| Vector3::new(x, y, z))
}

fn direction() -> impl Strategy<Value = Vector3> {
    vector(number()).prop_filter("no direction", |v| *v != Vector3::default())
}

fn matrix() -> impl Strategy<Value = Mat3x3> {
    [(); 3]
        .map(|()| prop::array::uniform3(whole()))
        .prop_map(Mat3x3::from_rows)
}

fn scaled(v: Vector3, exponent: i32) -> Vector3 {
    Vector3::from_glam(v.to_glam().map(|x| libm::scalbn(x, exponent)))
}

proptest! {
    #![proptest_config(config())]

    /// Tolerance: three rounded quotients and a rounded root.
    #[test]
    fn any_length_can_be_normalized(v in direction(), exponent in -900..=990) {
        let unit = scaled(v, exponent).normalized().unwrap();
        assert_abs_diff_eq!(unit.magnitude(), 1.0, epsilon = 4.0 * f64::EPSILON);
        assert_abs_diff_eq!(unit, v.normalized().unwrap(), epsilon = 4.0 * f64::EPSILON);
    }

    /// Tolerance: relative to the length.
    #[test]
    fn reflecting_twice_changes_nothing_and_once_keeps_the_length(
        v in direction(), n in direction(),
    ) {
        let n = n.as_normal().normalized().unwrap();
        let reflected = v.reflected_on(n);
        let rounding = 8.0 * f64::EPSILON * v.magnitude();
        assert_abs_diff_eq!(reflected.magnitude(), v.magnitude(), epsilon = rounding);
        assert_abs_diff_eq!(reflected.reflected_on(n), v, epsilon = rounding);
        assert_abs_diff_eq!(reflected.dot(n), v.dot(n), epsilon = rounding);
    }

    /// Tolerance: rounding of the projection, relative to the vector.
    #[test]
    fn the_rest_of_a_projection_is_perpendicular(a in direction(), b in direction()) {
        let rest = a - a.projected_on(b).unwrap();
        let scale = a.magnitude() * b.magnitude();
        assert_abs_diff_eq!(rest.dot(b), 0.0, epsilon = 4.0 * f64::EPSILON * scale);
    }

    /// Grassmann: a × (b × c) = b (a · c) - c (a · b).
    #[test]
    fn a_double_cross_product_lies_between_its_inner_factors(
        a in vector(whole()), b in vector(whole()), c in vector(whole()),
    ) {
        prop_assert_eq!(a.cross(b.cross(c)), b * a.dot(c) - c * a.dot(b));
    }

    #[test]
    fn an_angle_does_not_depend_on_lengths(
        a in vector(number()), b in vector(number()), k in -900..=900, l in -900..=900,
    ) {
        let (longer, other) = (scaled(a, k), scaled(b, l));
        prop_assert_eq!(longer.angle(other).to_bits(), a.angle(b).to_bits());
        prop_assert_eq!(other.angle(longer).to_bits(), a.angle(b).to_bits());
    }

    /// Laplace: the determinant is linear in each column.
    #[test]
    fn a_determinant_is_linear_in_a_column(
        m in matrix(), a in vector(whole()), b in vector(whole()), s in whole(),
    ) {
        for with in [Mat3x3::change_col_1, Mat3x3::change_col_2, Mat3x3::change_col_3] {
            let det = |column| with(m, column).determinant();
            prop_assert_eq!(det(a + b), det(a) + det(b));
            prop_assert_eq!(det(a * s), det(a) * s);
        }
    }

    #[test]
    fn determinants_multiply(a in matrix(), b in matrix()) {
        prop_assert_eq!((a * b).determinant(), a.determinant() * b.determinant());
    }
}

#[test]
fn the_longest_vector_has_a_direction_and_a_vector_of_no_numbers_none() {
    let longest = Vector3::new(f64::MAX, 0.0, -f64::MAX);
    let expected = Vector3::new(1.0, 0.0, -1.0) * 0.5_f64.sqrt();
    let unit = longest.normalized().unwrap();
    assert_abs_diff_eq!(unit, expected, epsilon = f64::EPSILON);
    for x in [0.0, -0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let vector = Vector3::new(0.0, x, 0.0);
        assert_eq!(vector.normalized(), None);
        assert_eq!(vector.as_normal().normalized(), None);
        assert_refused(vector.unit("gaze"), "gaze is", "not all of them 0");
        assert_refused(
            vector.as_normal().unit("gaze"),
            "gaze is",
            "not all of them 0",
        );
    }
    assert_eq!(longest.projected_on(Vector3::default()), None);
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
