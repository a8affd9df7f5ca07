//! Laws of all vectors and matrices, exact because no number is rounded.
//!
//! The same cases come every time; `PROPTEST_CASES=100000` makes more of them.

use a02_math::{Direction, Mat3x3, Vector3};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

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

fn matrix() -> impl Strategy<Value = Mat3x3> {
    [(); 3]
        .map(|()| prop::array::uniform3(whole()))
        .prop_map(Mat3x3::from_rows)
}

proptest! {
    #![proptest_config(config())]

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
        let (longer, other) = (a * libm::scalbn(1.0, k), b * libm::scalbn(1.0, l));
        prop_assert_eq!(longer.angle(other).to_bits(), a.angle(b).to_bits());
        prop_assert_eq!(other.angle(longer).to_bits(), a.angle(b).to_bits());
    }

    /// Laplace: the determinant is linear in each column.
    #[test]
    fn a_determinant_is_linear_in_a_column(
        m in matrix(), a in vector(whole()), b in vector(whole()), s in whole(),
    ) {
        let with: [fn(Mat3x3, Vector3) -> Mat3x3; 3] =
            [Mat3x3::change_col_1, Mat3x3::change_col_2, Mat3x3::change_col_3];
        for with in with {
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
