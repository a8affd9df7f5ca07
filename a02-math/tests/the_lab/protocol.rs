//! The formulas of the two texts that no experiment measures.
//!
//! On whole numbers of ordinary size the formulas hold, so that only the extreme cases
//! make them fail.

use a02_math::lab::protocol::{angle, projected_on, reflected_on};
use a02_math::{Normal3, Vector3};

#[test]
fn ordinary_vectors_have_the_printed_values() {
    let (a, b) = (Vector3::new(3.0, 4.0, 0.0), Vector3::new(0.0, 2.0, 0.0));
    assert_eq!(angle(a, b), 0.8);
    assert_eq!(projected_on(a, b), Vector3::new(0.0, 8.0, 0.0));
    let n = Normal3::new(0.0, 1.0, 0.0);
    assert_eq!(reflected_on(a, n), Vector3::new(3.0, -4.0, 0.0));
    let twice = Normal3::new(0.0, 2.0, 0.0);
    assert_eq!(reflected_on(a, twice), Vector3::new(3.0, -28.0, 0.0));
}
