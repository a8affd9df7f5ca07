//! The matrix: products by hand and by glam.

use a02_math::{Point3, Vector3};
use a07_transforms::Mat4x4;
use approx::{assert_abs_diff_eq, assert_abs_diff_ne};
use glam::DMat4;

/// Whole numbers: every product below is exact.
const A: [[f64; 4]; 4] = [
    [1.0, 2.0, 3.0, 4.0],
    [5.0, 6.0, 7.0, 8.0],
    [9.0, 10.0, 11.0, 12.0],
    [0.0, 0.0, 0.0, 1.0],
];
const B: [[f64; 4]; 4] = [
    [0.0, 1.0, 0.0, -2.0],
    [-1.0, 0.0, 3.0, 0.0],
    [2.0, 0.0, 1.0, 5.0],
    [0.0, 0.0, 0.0, 1.0],
];

#[test]
fn rows_are_as_written_on_paper() {
    let a = Mat4x4::from_rows(A);
    assert_eq!(a * Vector3::new(1.0, 0.0, 0.0), Vector3::new(1.0, 5.0, 9.0));
    assert_eq!(
        a * Vector3::new(1.0, 1.0, 1.0),
        Vector3::new(6.0, 18.0, 30.0)
    );
}

#[test]
fn the_last_column_moves_points_and_no_vectors() {
    let a = Mat4x4::from_rows(A);
    assert_eq!(a * Point3::ORIGIN, Point3::new(4.0, 8.0, 12.0));
    assert_eq!(
        a * Point3::new(1.0, 1.0, 1.0),
        Point3::new(10.0, 26.0, 42.0)
    );
    assert_eq!(a * Vector3::default(), Vector3::default());
}

#[test]
fn a_product_by_hand() {
    let expected = [
        [4.0, 1.0, 9.0, 17.0],
        [8.0, 5.0, 25.0, 33.0],
        [12.0, 9.0, 41.0, 49.0],
        [0.0, 0.0, 0.0, 1.0],
    ];
    let (a, b) = (Mat4x4::from_rows(A), Mat4x4::from_rows(B));
    assert_eq!(a * b, Mat4x4::from_rows(expected));
    assert_ne!(b * a, a * b);
    // Applied to a point: first b, then a.
    let p = Point3::new(1.0, -2.0, 3.0);
    assert_eq!((a * b) * p, a * (b * p));
    assert_eq!(b * p, Point3::new(-4.0, 8.0, 10.0));
}

#[test]
fn a_product_by_glam() {
    let by_glam = |rows: [[f64; 4]; 4]| DMat4::from_cols_array_2d(&rows).transpose();
    let product = by_glam(A) * by_glam(B);
    let expected = Mat4x4::from_rows(product.transpose().to_cols_array_2d());
    assert_eq!(Mat4x4::from_rows(A) * Mat4x4::from_rows(B), expected);
}

#[test]
fn the_identity_changes_nothing() {
    let a = Mat4x4::from_rows(A);
    assert_eq!(a * Mat4x4::IDENTITY, a);
    assert_eq!(Mat4x4::IDENTITY * a, a);
    assert_eq!(Mat4x4::IDENTITY.transposed(), Mat4x4::IDENTITY);
    let p = Point3::new(1.0, 2.0, 3.0);
    assert_eq!(Mat4x4::IDENTITY * p, p);
}

#[test]
fn transposing_exchanges_rows_and_columns() {
    let columns = std::array::from_fn(|i| A.map(|row| row[i]));
    let a = Mat4x4::from_rows(A);
    assert_eq!(a.transposed(), Mat4x4::from_rows(columns));
    assert_eq!(a.transposed().transposed(), a);
}

#[test]
fn one_bad_entry_is_within_no_limit() {
    assert!(Mat4x4::from_rows(A).is_within(1e100));
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for (row, column) in (0..16).map(|i| (i / 4, i % 4)) {
            let mut rows = A;
            rows[row][column] = bad;
            assert!(!Mat4x4::from_rows(rows).is_within(1e100));
        }
    }
}

#[test]
fn matrices_can_be_compared_within_a_tolerance() {
    let (a, mut rows) = (Mat4x4::from_rows(A), A);
    rows[2][1] += 1e-9;
    assert_abs_diff_eq!(a, Mat4x4::from_rows(rows), epsilon = 1.1e-9);
    assert_abs_diff_ne!(a, Mat4x4::from_rows(rows), epsilon = 0.9e-9);
    // Without a word one unit of rounding is allowed.
    let with = |corner| {
        let mut rows = B;
        rows[3][3] = corner;
        Mat4x4::from_rows(rows)
    };
    assert_abs_diff_eq!(with(1.0 + f64::EPSILON), with(1.0));
    assert_abs_diff_ne!(with(1.0 + 2.0 * f64::EPSILON), with(1.0));
}
