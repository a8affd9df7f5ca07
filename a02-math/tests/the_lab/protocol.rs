//! The formulas of the two texts.
//!
//! On whole numbers of ordinary size the formulas hold, so that only the extreme cases
//! make them fail.

use a02_math::lab::protocol::{
    angle, angle_by_arc_cosine, cramer, normalized, projected_on, reflected_on,
};
use a02_math::{Mat3x3, Normal3, Vector3};

#[test]
fn ordinary_vectors_have_the_printed_values() {
    let (a, b) = (Vector3::new(3.0, 4.0, 0.0), Vector3::new(0.0, 2.0, 0.0));
    assert_eq!(normalized(b), Vector3::new(0.0, 1.0, 0.0));
    assert_eq!(angle(a, b), 0.8);
    assert_eq!(angle_by_arc_cosine(a, b), libm::acos(0.8));
    assert_eq!(projected_on(a, b), Vector3::new(0.0, 8.0, 0.0));
    let n = Normal3::new(0.0, 1.0, 0.0);
    assert_eq!(reflected_on(a, n), Vector3::new(3.0, -4.0, 0.0));
    let twice = Normal3::new(0.0, 2.0, 0.0);
    assert_eq!(reflected_on(a, twice), Vector3::new(3.0, -28.0, 0.0));
}

#[test]
fn a_system_gives_its_solution() {
    let m = Mat3x3::from_rows([[2.0, 1.0, 0.0], [0.0, 4.0, 1.0], [1.0, 0.0, 1.0]]);
    let solution = Vector3::new(1.0, -2.0, 3.0);
    assert_eq!(m.determinant(), 9.0);
    assert_eq!(cramer(m, m * solution), solution);
}
