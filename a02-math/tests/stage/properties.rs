//! Laws of all vectors and matrices: exact where the numbers are small and whole,
//! and elsewhere within a bound of the rounding error.
//!
//! The same cases come every time; `PROPTEST_CASES=100000` makes more of them.
//! In the bounds u is the unit of rounding, half of eps. Terms with u² are left
//! out, and the bounds rounded up.

use std::f64::consts::PI;

use a02_math::{Direction, Mat3x3, Vector3};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

const EPS: f64 = f64::EPSILON;

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

/// So small that products of three of them, and sums of these, are exact.
fn whole() -> impl Strategy<Value = f64> {
    (-1000..=1000).prop_map(f64::from)
}

fn vector(number: impl Strategy<Value = f64>) -> impl Strategy<Value = Vector3> {
    prop::array::uniform3(number).prop_map(|[x, y, z]| Vector3::new(x, y, z))
}

type Rows = [[f64; 3]; 3];

fn rows<N: Strategy<Value = f64>>(number: fn() -> N) -> impl Strategy<Value = Rows> {
    [(); 3].map(|()| prop::array::uniform3(number()))
}

/// All numbers without their signs: rounding errors are relative to them.
fn unsigned(rows: Rows) -> Mat3x3 {
    Mat3x3::from_rows(rows.map(|row| row.map(f64::abs)))
}

/// The determinant with a plus before each product.
fn permanent(rows: Rows) -> f64 {
    let [a, b, c] = rows.map(|row| row.map(f64::abs));
    a[0] * (b[1] * c[2] + b[2] * c[1])
        + a[1] * (b[0] * c[2] + b[2] * c[0])
        + a[2] * (b[0] * c[1] + b[1] * c[0])
}

const AXES: [Vector3; 3] = [
    Vector3::new(1.0, 0.0, 0.0),
    Vector3::new(0.0, 1.0, 0.0),
    Vector3::new(0.0, 0.0, 1.0),
];

/// The columns of a matrix side by side, as rows.
fn columns(matrix: Mat3x3) -> Rows {
    AXES.map(|axis| (matrix * axis).to_glam().to_array())
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

    /// Each coordinate of the product is off by 2u (|a_i b_j| + |a_j b_i|), and
    /// the dot product by 3u of as much, times a: together 10u (|a1 a2 b3| +
    /// |a2 a3 b1| + |a3 a1 b2|), at most 10u/√3 |a|² |b| by Cauchy and Schwarz.
    #[test]
    fn a_cross_product_is_perpendicular_to_its_factors(
        a in vector(number()), b in vector(number()),
    ) {
        let bound = 3.0 * EPS * a.dot(a) * b.magnitude();
        prop_assert!(a.cross(b).dot(a).abs() <= bound);
        prop_assert!(b.cross(a).dot(a).abs() <= bound);
    }

    /// Lagrange: |a × b|² + (a · b)² = |a|² |b|². Of this last, the first square
    /// is off by (4√2 + 3)u, the second by 7u, and the product itself by 7u.
    #[test]
    fn sine_and_cosine_share_the_lengths(a in vector(number()), b in vector(number())) {
        let (cross, dot, whole) = (a.cross(b), a.dot(b), a.dot(a) * b.dot(b));
        let off = cross.dot(cross) + dot * dot - whole;
        prop_assert!(off.abs() <= 12.0 * EPS * whole);
    }

    /// A sum is off by u of each coordinate, a length by 3u of itself.
    #[test]
    fn a_detour_is_never_shorter(a in vector(number()), b in vector(number())) {
        let detour = a.magnitude() + b.magnitude();
        prop_assert!((a + b).magnitude() <= detour * (1.0 + 4.0 * EPS));
    }

    /// Scaling is exact, and so nothing changes.
    #[test]
    fn an_angle_does_not_depend_on_lengths(
        a in vector(number()), b in vector(number()), k in -900..=900, l in -900..=900,
    ) {
        let (longer, other) = (a * libm::scalbn(1.0, k), b * libm::scalbn(1.0, l));
        prop_assert_eq!(longer.angle(other).to_bits(), a.angle(b).to_bits());
        prop_assert_eq!(other.angle(longer).to_bits(), a.angle(b).to_bits());
    }

    /// Sine and cosine keep their values, but for a sign. Two arc tangents are
    /// off by less than a unit in the last place of π, 2 eps, and their sum by
    /// half of it.
    #[test]
    fn the_angle_to_the_opposite_is_the_rest_of_a_half_turn(
        a in vector(number()), b in vector(number()),
    ) {
        prop_assume!(a != Vector3::default() && b != Vector3::default());
        prop_assert!((a.angle(b) + a.angle(-b) - PI).abs() <= 6.0 * EPS);
    }

    /// Laplace: the determinant is linear in each column.
    #[test]
    fn a_determinant_is_linear_in_a_column(
        m in rows(whole), a in vector(whole()), b in vector(whole()), s in whole(),
    ) {
        let m = Mat3x3::from_rows(m);
        let with: [fn(Mat3x3, Vector3) -> Mat3x3; 3] =
            [Mat3x3::change_col_1, Mat3x3::change_col_2, Mat3x3::change_col_3];
        for with in with {
            let det = |column| with(m, column).determinant();
            prop_assert_eq!(det(a + b), det(a) + det(b));
            prop_assert_eq!(det(a * s), det(a) * s);
        }
    }

    /// A determinant is off by 6u of its permanent. The determinant of a product is
    /// off by another 9u of the permanent of |A| |B|, because each column is off by 3u,
    /// and that permanent is at least the product of the two.
    #[test]
    fn determinants_multiply(a in rows(number), b in rows(number)) {
        let [one, other] = [a, b].map(Mat3x3::from_rows);
        let products = (one * other).determinant() - one.determinant() * other.determinant();
        let all = permanent(columns(unsigned(a) * unsigned(b)));
        prop_assert!(products.abs() <= 15.0 * EPS * all);
    }

    /// Each of the two products on each side is off by 3u of |A| |B| |C|.
    #[test]
    fn it_does_not_matter_which_product_comes_first(
        a in rows(number), b in rows(number), c in rows(number), v in vector(number()),
    ) {
        let [l, m, n] = [a, b, c].map(Mat3x3::from_rows);
        let all = columns(unsigned(a) * unsigned(b) * unsigned(c));
        let (left, right) = (columns((l * m) * n), columns(l * (m * n)));
        for (left, (right, all)) in left.iter().flatten().zip(right.iter().flatten().zip(all.iter().flatten())) {
            prop_assert!((left - right).abs() <= 7.0 * EPS * all);
        }

        let all = unsigned(a) * (unsigned(b) * Vector3::from_glam(v.to_glam().abs()));
        let off = ((l * m) * v - l * (m * v)).to_glam().abs();
        prop_assert!(off.cmple(all.to_glam() * (7.0 * EPS)).all());
    }
}
