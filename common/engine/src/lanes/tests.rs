//! Tests of lanes. That operations on four vectors have the bits of the scalar ones is seen by the
//! comparisons with the lesson in the tests of the stages.

use glam::DVec3;

use super::vector::is_square_of_a_length;
use super::{Lanes, Vector3x4};
use crate::vector::normalized;

/// Ordinary numbers and the extremes of all kinds.
const NUMBERS: [f64; 8] = [
    0.0,
    1.0,
    -7.0,
    1e-200,
    -5e-324,
    1e200,
    f64::INFINITY,
    f64::NAN,
];

#[test]
fn vectors_of_length_1_are_marked() {
    let number = |i: usize| NUMBERS[i % 8];
    for i in 0..8 * 8 * 8 {
        let vectors = [i, i + 1, i + 2, i + 3];
        let vectors = vectors.map(|i| DVec3::new(number(i), number(i / 8), number(i / 64)));
        let (units, are_units) = Vector3x4::new(vectors).normalized();
        let units = units.to_lanes();
        for (lane, vector) in vectors.into_iter().enumerate() {
            let is_unit = are_units.to_bitmask() >> lane & 1 != 0;
            let is_in_range = (1e-280..=1e280).contains(&vector.length_squared());
            assert_eq!(is_unit, is_in_range, "{vector}");
            assert!(
                !is_unit || normalized(vector) == Some(units[lane]),
                "{vector}"
            );
        }
    }
    let squares = [1e-280, 1e280, 1e-280_f64.next_down(), 1e280_f64.next_up()];
    let marked = is_square_of_a_length(Lanes::new(squares));
    assert_eq!(marked.to_bitmask(), 0b0011);
}
