//! Laws of all vectors and matrices, also of extremely long and short vectors.

use a02_math::{Direction, Mat3x3, Point3, Vector3};
use approx::assert_abs_diff_eq;
use testing::{Random, assert_refused, for_seeds};

/// The number of cases of each law.
const CASES: u64 = 1000;

/// Of either sign, up to 2^30 and down to 2^-30 and 0.
fn number(random: &mut Random) -> f64 {
    let exponent = random.below(61) as i32 - 30;
    match random.below(10) {
        0 => 0.0,
        _ => libm::scalbn(random.between(-1.0, 1.0), exponent),
    }
}

/// So small that products of six of them, and sums of these, are exact.
fn whole(random: &mut Random) -> f64 {
    f64::from(random.below(201)) - 100.0
}

fn vector(number: fn(&mut Random) -> f64, random: &mut Random) -> Vector3 {
    Vector3::new(number(random), number(random), number(random))
}

/// A vector that is not 0.
fn direction(random: &mut Random) -> Vector3 {
    loop {
        let vector = vector(number, random);
        if vector != Vector3::default() {
            return vector;
        }
    }
}

fn matrix(random: &mut Random) -> Mat3x3 {
    Mat3x3::from_rows([(); 3].map(|()| [(); 3].map(|()| whole(random))))
}

/// The vector times a power of two, up to 2^900 and down to 2^-900.
fn scaled(v: Vector3, random: &mut Random) -> Vector3 {
    let exponent = random.below(1801) as i32 - 900;
    Vector3::from_glam(v.to_glam().map(|x| libm::scalbn(x, exponent)))
}

/// Tolerance: three rounded quotients and a rounded root.
#[test]
fn any_length_can_be_normalized() {
    for_seeds(CASES, |random| {
        let v = direction(random);
        let unit = scaled(v, random).normalized().unwrap();
        assert_abs_diff_eq!(unit.magnitude(), 1.0, epsilon = 4.0 * f64::EPSILON);
        assert_abs_diff_eq!(unit, v.normalized().unwrap(), epsilon = 4.0 * f64::EPSILON);
    });
}

/// 49 · (1/49) is below 1.
#[test]
fn a_quotient_is_rounded_once() {
    assert_eq!(
        Vector3::new(49.0, -98.0, 0.0) / 49.0,
        Vector3::new(1.0, -2.0, 0.0)
    );
}

/// Tolerance: relative to the length.
#[test]
fn reflecting_twice_changes_nothing_and_once_keeps_the_length() {
    for_seeds(CASES, |random| {
        let (v, n) = (direction(random), direction(random));
        let n = n.as_normal().normalized().unwrap();
        let reflected = v.reflected_on(n);
        let rounding = 8.0 * f64::EPSILON * v.magnitude();
        assert_abs_diff_eq!(reflected.magnitude(), v.magnitude(), epsilon = rounding);
        assert_abs_diff_eq!(reflected.reflected_on(n), v, epsilon = rounding);
        assert_abs_diff_eq!(reflected.dot(n), v.dot(n), epsilon = rounding);
    });
}

/// Tolerance: rounding of the projection, relative to the vector.
#[test]
fn the_rest_of_a_projection_is_perpendicular() {
    for_seeds(CASES, |random| {
        let (a, b) = (direction(random), direction(random));
        let rest = a - a.projected_on(b).unwrap();
        let scale = a.magnitude() * b.magnitude();
        assert_abs_diff_eq!(rest.dot(b), 0.0, epsilon = 4.0 * f64::EPSILON * scale);
    });
}

/// Grassmann: a × (b × c) = b (a · c) - c (a · b).
#[test]
fn a_double_cross_product_lies_between_its_inner_factors() {
    for_seeds(CASES, |random| {
        let [a, b, c] = [(); 3].map(|()| vector(whole, random));
        assert_eq!(a.cross(b.cross(c)), b * a.dot(c) - c * a.dot(b));
    });
}

#[test]
fn an_angle_does_not_depend_on_lengths() {
    for_seeds(CASES, |random| {
        let [a, b] = [(); 2].map(|()| vector(number, random));
        let [longer, other] = [a, b].map(|v| scaled(v, random));
        assert_eq!(longer.angle(other).to_bits(), a.angle(b).to_bits());
        assert_eq!(other.angle(longer).to_bits(), a.angle(b).to_bits());
    });
}

/// Laplace: the determinant is linear in each column.
#[test]
fn a_determinant_is_linear_in_a_column() {
    for_seeds(CASES, |random| {
        let (m, s) = (matrix(random), whole(random));
        let [a, b] = [(); 2].map(|()| vector(whole, random));
        for with in [
            Mat3x3::change_col_1,
            Mat3x3::change_col_2,
            Mat3x3::change_col_3,
        ] {
            let det = |column| with(m, column).determinant();
            assert_eq!(det(a + b), det(a) + det(b));
            assert_eq!(det(a * s), det(a) * s);
        }
    });
}

#[test]
fn determinants_multiply() {
    for_seeds(CASES, |random| {
        let (a, b) = (matrix(random), matrix(random));
        assert_eq!((a * b).determinant(), a.determinant() * b.determinant());
    });
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
