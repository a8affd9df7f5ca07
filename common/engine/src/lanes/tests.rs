//! Tests of lanes. That operations on four vectors have the bits of the scalar ones is seen by the
//! comparisons with the lesson in the tests of the stages.

use glam::DVec3;

use super::level::baseline;
use super::vector::is_square_of_a_length;
use super::{Vector3x4, bits_of, lanes};
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
        let (units, are_units) = Vector3x4::new(baseline(), vectors).normalized();
        let units = units.to_lanes();
        for (lane, vector) in vectors.into_iter().enumerate() {
            let is_unit = bits_of(are_units) >> lane & 1 != 0;
            let is_in_range = (1e-280..=1e280).contains(&vector.length_squared());
            assert_eq!(is_unit, is_in_range, "{vector}");
            assert!(
                !is_unit || normalized(vector) == Some(units[lane]),
                "{vector}"
            );
        }
    }
    let squares = [1e-280, 1e280, 1e-280_f64.next_down(), 1e280_f64.next_up()];
    let marked = is_square_of_a_length(lanes(baseline(), squares));
    assert_eq!(bits_of(marked), 0b0011);
}
