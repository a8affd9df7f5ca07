//! Tests of lanes: operations on four vectors have the bits of the scalar operations, on
//! any processor and for any numbers.

use std::array::from_fn;

use glam::DVec3;

use super::{Lanes, Vector3x4, copysign, first_positive, is_square_of_a_length, mask, select};
use crate::vector::{largest_coordinate, normalized};

/// Ordinary numbers and the extremes of all kinds.
const NUMBERS: [f64; 13] = [
    0.0,
    -0.0,
    1.0,
    -7.0,
    0.1,
    -1.0 / 3.0,
    1e-200,
    -5e-324,
    1e200,
    -f64::MAX,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
];
/// The number of vectors with these coordinates.
const VECTORS: usize = NUMBERS.len().pow(3);

/// Calls `check` with every vector of these numbers in every lane, and with other
/// vectors in the other lanes.
fn for_fours(check: impl Fn([DVec3; 4], [DVec3; 4])) {
    let number = |i: usize| NUMBERS[i % NUMBERS.len()];
    let vector = |i: usize| DVec3::new(number(i), number(i / 13), number(i / 169));
    for i in 0..VECTORS {
        for shift in [0, 1, 100, 1000] {
            let a = from_fn(|lane| vector(i + lane));
            // Seven has no factor in common with the number of vectors.
            let b = from_fn(|lane| vector((7 * (i + lane) + shift) % VECTORS));
            check(a, b);
        }
    }
}

/// Like `for_fours`, with single numbers.
fn for_four_numbers(check: impl Fn([f64; 4], [f64; 4])) {
    for_fours(|a, b| check(a.map(|v| v.x), b.map(|v| v.x)));
}

/// Processors differ in the bits of a NaN, so that any NaN equals any other.
#[track_caller]
fn assert_same(lanes: Lanes, scalar: impl Fn(usize) -> f64) {
    for (i, a) in lanes.to_array().into_iter().enumerate() {
        let b = scalar(i);
        let same = a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
        assert!(same, "lane {i} of {lanes:?}, scalar {b:?}");
    }
}

#[track_caller]
fn assert_same_vectors(vectors: Vector3x4, scalar: impl Fn(usize) -> DVec3) {
    assert_same(vectors.x, |i| scalar(i).x);
    assert_same(vectors.y, |i| scalar(i).y);
    assert_same(vectors.z, |i| scalar(i).z);
}

fn bits(f: impl Fn(usize) -> bool) -> u32 {
    (0..4).map(|lane| u32::from(f(lane)) << lane).sum()
}

#[test]
fn arithmetic_has_the_bits_of_single_vectors() {
    for_fours(|a, b| {
        let (v, w) = (Vector3x4::new(a), Vector3x4::new(b));
        assert_same_vectors(v + w, |i| a[i] + b[i]);
        assert_same_vectors(v - w, |i| a[i] - b[i]);
        assert_same_vectors(v * w.x, |i| a[i] * b[i].x);
        assert_same_vectors(-v, |i| -a[i]);
        assert_same(v.dot(w), |i| a[i].dot(b[i]));
        // With the operations of the lesson.
        assert_same_vectors(v.reflected_on(w), |i| b[i] * (2.0 * b[i].dot(a[i])) - a[i]);
        if a.iter().all(|v| !v.is_nan()) {
            assert_same(v.largest_coordinate(), |i| largest_coordinate(a[i]));
        }
    });
    for_four_numbers(|a, b| {
        let (v, w) = (Lanes::new(a), Lanes::new(b));
        assert_same(v.sqrt(), |i| a[i].sqrt());
        assert_same(v.abs(), |i| a[i].abs());
        assert_same(v / w, |i| a[i] / b[i]);
        assert_same(copysign(v, w), |i| a[i].copysign(b[i]));
        assert_same(first_positive(v, w), |i| {
            let mut positive = [a[i], b[i]].into_iter().filter(|t| *t > 0.0);
            positive.next().unwrap_or(f64::NAN)
        });
    });
}

#[test]
fn vectors_of_length_1_are_marked() {
    for_fours(|a, _| {
        let (units, are_units) = Vector3x4::new(a).normalized();
        let in_range = |i: usize| (1e-280..=1e280).contains(&a[i].dot(a[i]));
        assert_eq!(are_units.to_bitmask(), bits(in_range), "{a:?}");
        let marked = units.or(are_units, Vector3x4::splat(DVec3::ZERO));
        let unit = |i: usize| normalized(a[i]).filter(|_| in_range(i));
        assert_same_vectors(marked, |i| unit(i).unwrap_or_default());
    });
    let squares = [1e-280, 1e280, 1e-280_f64.next_down(), 1e280_f64.next_up()];
    let marked = is_square_of_a_length(Lanes::new(squares));
    assert_eq!(marked.to_bitmask(), 0b0011);
}

#[test]
fn a_mask_chooses_lanes() {
    for chosen in 0..16 {
        let mask = mask(chosen);
        let is_chosen = |i: usize| chosen >> i & 1 != 0;
        assert_eq!((mask.to_bitmask(), mask.all()), (chosen, chosen == 15));
        assert_eq!((!mask).to_bitmask(), 15 - chosen);
        for_fours(|a, b| {
            let (v, w) = (Vector3x4::new(a), Vector3x4::new(b));
            let either = |i: usize| if is_chosen(i) { a[i] } else { b[i] };
            assert_same_vectors(v.or(mask, w), either);
            assert_same(select(mask, v.x, w.x), |i| either(i).x);
            assert_same_vectors(v.negated(mask), |i| if is_chosen(i) { -a[i] } else { a[i] });
            // A mask also makes a channel black, and a `t` NaN.
            assert_same(v.x & mask, |i| if is_chosen(i) { a[i].x } else { 0.0 });
            assert_same(v.x | mask, |i| if is_chosen(i) { f64::NAN } else { a[i].x });
        });
    }
}

/// Neither scalars nor lanes define which of 0 and -0 is the greater.
#[test]
fn nan_is_neither_less_nor_greater_nor_equal_and_dropped_by_max_and_min() {
    for_four_numbers(|a, b| {
        let (v, w) = (Lanes::new(a), Lanes::new(b));
        assert_eq!(v.simd_lt(w).to_bitmask(), bits(|i| a[i] < b[i]));
        assert_eq!(v.simd_le(w).to_bitmask(), bits(|i| a[i] <= b[i]));
        assert_eq!(v.simd_gt(w).to_bitmask(), bits(|i| a[i] > b[i]));
        assert_eq!(v.simd_ge(w).to_bitmask(), bits(|i| a[i] >= b[i]));
        assert_eq!(v.simd_eq(w).to_bitmask(), bits(|i| a[i] == b[i]));
        assert_eq!(v.is_nan().to_bitmask(), bits(|i| a[i].is_nan()));

        let no_sign = |x: f64| if x == 0.0 { 0.0 } else { x };
        let without_signs = |lanes: Lanes| Lanes::new(lanes.to_array().map(no_sign));
        assert_same(without_signs(v.max(w)), |i| no_sign(a[i].max(b[i])));
        assert_same(without_signs(v.min(w)), |i| no_sign(a[i].min(b[i])));
        // The fast ones are undefined where there is a NaN.
        let nan = v.is_nan() | w.is_nan();
        let known = |fast: Lanes| without_signs(select(nan, Lanes::ZERO, fast));
        let is_nan = |i: usize| a[i].is_nan() || b[i].is_nan();
        let defined = |i: usize, x: f64| if is_nan(i) { 0.0 } else { no_sign(x) };
        assert_same(known(v.fast_max(w)), |i| defined(i, a[i].max(b[i])));
        assert_same(known(v.fast_min(w)), |i| defined(i, a[i].min(b[i])));
    });
}
