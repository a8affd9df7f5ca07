//! The fourteen acceptance checks of the course, and the checks of the second course. Its
//! angle and projection are the extreme cases F28 and F33, and the course's linear system
//! is K01.
//!
//! Where the inputs are small whole numbers the results are exact and compared
//! without a tolerance.

use a02_math::{Direction, Mat3x3, Normal3, Point3, Vector3};

const fn v(x: f64, y: f64, z: f64) -> Vector3 {
    Vector3::new(x, y, z)
}

const fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

const fn n(x: f64, y: f64, z: f64) -> Normal3 {
    Normal3::new(x, y, z)
}

#[test]
fn checks_1_to_8_of_the_course_sums_and_products() {
    assert_eq!(n(1.0, 2.0, 3.0) * 0.5, n(0.5, 1.0, 1.5));
    assert_eq!(n(1.0, 2.0, 3.0) + n(3.0, 2.0, 1.0), n(4.0, 4.0, 4.0));
    for ((x, y, z), dot) in [((1.0, 0.0, 0.0), 1.0), ((0.0, 1.0, 0.0), 0.0)] {
        assert_eq!(n(1.0, 0.0, 0.0).dot(v(x, y, z)), dot);
        assert_eq!(v(1.0, 0.0, 0.0).dot(n(x, y, z)), dot);
        assert_eq!(v(1.0, 0.0, 0.0).dot(v(x, y, z)), dot);
    }
    assert_eq!(p(1.0, 1.0, 1.0) - p(2.0, 2.0, 0.0), v(-1.0, -1.0, 1.0));
    assert_eq!(p(1.0, 1.0, 1.0) - v(4.0, 3.0, 2.0), p(-3.0, -2.0, -1.0));
    assert_eq!(p(1.0, 1.0, 1.0) + v(4.0, 3.0, 2.0), p(5.0, 4.0, 3.0));
    assert_eq!(v(1.0, 1.0, 1.0).magnitude(), 3.0_f64.sqrt());
    assert_eq!(v(1.0, 1.0, 1.0) + n(4.0, 3.0, 2.0), v(5.0, 4.0, 3.0));
    assert_eq!(v(1.0, 1.0, 1.0) - n(4.0, 3.0, 2.0), v(-3.0, -2.0, -1.0));
}

#[test]
fn checks_9_and_10_of_the_course_reflection_on_an_axis() {
    let (falling, rising) = (v(0.707, -0.707, 0.0), v(0.707, 0.707, 0.0));
    assert_eq!((-falling).reflected_on(n(0.0, 1.0, 0.0)), rising);
    assert_eq!(rising.reflected_on(n(1.0, 0.0, 0.0)), falling);
}

#[test]
fn checks_11_to_14_of_the_course_matrices() {
    let m = Mat3x3::from_rows([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]]);
    assert_eq!(Mat3x3::IDENTITY * p(3.0, 2.0, 1.0), p(3.0, 2.0, 1.0));
    assert_eq!(Mat3x3::IDENTITY * v(3.0, 2.0, 1.0), v(3.0, 2.0, 1.0));
    assert_eq!(m * p(0.0, 0.0, 1.0), p(3.0, 6.0, 9.0));
    assert_eq!(m * Mat3x3::IDENTITY, m);
    let mirror = Mat3x3::from_rows([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]);
    let mirrored = Mat3x3::from_rows([[3.0, 2.0, 1.0], [6.0, 5.0, 4.0], [9.0, 8.0, 7.0]]);
    assert_eq!(m * mirror, mirrored);
    let eight = v(8.0, 8.0, 8.0);
    for (changed, rows) in [
        (
            m.change_col_1(eight),
            [[8.0, 2.0, 3.0], [8.0, 5.0, 6.0], [8.0, 8.0, 9.0]],
        ),
        (
            m.change_col_2(eight),
            [[1.0, 8.0, 3.0], [4.0, 8.0, 6.0], [7.0, 8.0, 9.0]],
        ),
        (
            m.change_col_3(eight),
            [[1.0, 2.0, 8.0], [4.0, 5.0, 8.0], [7.0, 8.0, 8.0]],
        ),
    ] {
        assert_eq!(changed, Mat3x3::from_rows(rows));
    }
}

/// The vector of the second course's checks, 10.5 long.
const V: Vector3 = v(2.0, 2.5, 10.0);

#[test]
fn second_course_sums_multiples_and_equality() {
    assert_eq!(V.magnitude(), 10.5);
    assert_eq!(V + v(2.0, 3.5, 2.0), v(4.0, 6.0, 12.0));
    assert_eq!(V - v(2.0, 3.5, 2.0), v(0.0, -1.0, 8.0));
    assert_eq!(V * 3.0, v(6.0, 7.5, 30.0));
    assert_eq!(V.normalized(), Some(v(2.0 / 10.5, 2.5 / 10.5, 10.0 / 10.5)));
    assert_ne!(V, v(2.0, 2.5, 10.0 + 2e-15));
}

#[test]
fn second_course_products() {
    assert_eq!(V.dot(v(1.0, 9.0, 3.0)), 54.5);
    assert_eq!(V.cross(v(8.0, 9.0, -7.0)), v(-107.5, 94.0, -2.0));
    let squared: f64 = 107.5 * 107.5 + 94.0 * 94.0 + 2.0 * 2.0;
    assert_eq!(V.parallelogram_area(v(8.0, 9.0, -7.0)), squared.sqrt());
}
