//! The matrix: products by hand.

use a02_math::{Point3, Vector3};
use a07_transforms::Mat4x4;

/// Whole numbers: every product below is exact.
const A: [[f64; 4]; 4] = [
    [1.0, 2.0, 3.0, 4.0],
    [5.0, 6.0, 7.0, 8.0],
    [9.0, 10.0, 11.0, 12.0],
    [0.0, 0.0, 0.0, 1.0],
];

#[test]
fn the_last_column_moves_points_and_no_vectors() {
    let a = Mat4x4::from_rows(A);
    for ([x, y, z], vector, point) in [
        ([0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [4.0, 8.0, 12.0]),
        ([1.0, 0.0, 0.0], [1.0, 5.0, 9.0], [5.0, 13.0, 21.0]),
        ([1.0, 1.0, 1.0], [6.0, 18.0, 30.0], [10.0, 26.0, 42.0]),
    ] {
        assert_eq!(a * Vector3::new(x, y, z), Vector3::from_glam(vector.into()));
        assert_eq!(a * Point3::new(x, y, z), Point3::from_glam(point.into()));
    }
}

#[test]
fn a_product_applies_its_right_factor_first() {
    let b = [
        [0.0, 1.0, 0.0, -2.0],
        [-1.0, 0.0, 3.0, 0.0],
        [2.0, 0.0, 1.0, 5.0],
        [0.0, 0.0, 0.0, 1.0],
    ];
    let expected = [
        [4.0, 1.0, 9.0, 17.0],
        [8.0, 5.0, 25.0, 33.0],
        [12.0, 9.0, 41.0, 49.0],
        [0.0, 0.0, 0.0, 1.0],
    ];
    let (a, b) = (Mat4x4::from_rows(A), Mat4x4::from_rows(b));
    assert_eq!(a * b, Mat4x4::from_rows(expected));
    let p = Point3::new(1.0, -2.0, 3.0);
    assert_eq!(b * p, Point3::new(-4.0, 8.0, 10.0));
    assert_eq!((a * b) * p, a * (b * p));
    assert_eq!((a * Mat4x4::IDENTITY, Mat4x4::IDENTITY * a), (a, a));
}

#[test]
fn transposing_exchanges_rows_and_columns() {
    let columns = std::array::from_fn(|i| A.map(|row| row[i]));
    let transposed = Mat4x4::from_rows(A).transposed();
    assert_eq!(transposed.rows(), columns);
    assert_eq!(transposed.transposed().rows(), A);
}
