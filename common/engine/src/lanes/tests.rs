//! Tests of lanes: operations on four vectors have the bits of the scalar operations, on
//! any processor and for any numbers.

use std::array;

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
            let a = array::from_fn(|lane| vector(i + lane));
            // Seven has no factor in common with the number of vectors.
            let b = array::from_fn(|lane| vector((7 * (i + lane) + shift) % VECTORS));
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
fn assert_same(lanes: Lanes, scalar: [f64; 4]) {
    for (a, b) in lanes.to_array().into_iter().zip(scalar) {
        let same = a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
        assert!(same, "lanes {lanes:?}, scalars {scalar:?}");
    }
}

#[track_caller]
fn assert_same_vectors(vectors: Vector3x4, scalar: [DVec3; 4]) {
    assert_same(vectors.x, scalar.map(|v| v.x));
    assert_same(vectors.y, scalar.map(|v| v.y));
    assert_same(vectors.z, scalar.map(|v| v.z));
}

/// A selected vector keeps its bits, even those of a NaN.
#[track_caller]
fn assert_kept(vectors: Vector3x4, scalar: [DVec3; 4]) {
    let bits = |v: DVec3| v.to_array().map(f64::to_bits);
    for (a, b) in vectors.to_lanes().into_iter().zip(scalar) {
        assert_eq!(bits(a), bits(b), "lane {a}, scalar {b}");
    }
}

fn lanes(f: impl Fn(usize) -> f64) -> [f64; 4] {
    array::from_fn(f)
}

fn vectors(f: impl Fn(usize) -> DVec3) -> [DVec3; 4] {
    array::from_fn(f)
}

fn bits(f: impl Fn(usize) -> bool) -> u32 {
    (0..4).map(|lane| u32::from(f(lane)) << lane).sum()
}

/// The reflected vector, with the operations of the lesson.
fn reflected_on(v: DVec3, n: DVec3) -> DVec3 {
    n * (2.0 * n.dot(v)) - v
}

#[test]
fn arithmetic_has_the_bits_of_single_vectors() {
    for_fours(|a, b| {
        let (v, w) = (Vector3x4::new(a), Vector3x4::new(b));
        assert_same_vectors(v + w, vectors(|i| a[i] + b[i]));
        assert_same_vectors(v - w, vectors(|i| a[i] - b[i]));
        assert_same_vectors(v * w.x, vectors(|i| a[i] * b[i].x));
        assert_same_vectors(-v, a.map(|a| -a));
        assert_same(v.dot(w), lanes(|i| a[i].dot(b[i])));
        let reflected = vectors(|i| reflected_on(a[i], b[i]));
        assert_same_vectors(v.reflected_on(w), reflected);
        assert_same_vectors(Vector3x4::splat(a[0]), [a[0]; 4]);
    });
}

#[test]
fn vectors_of_length_1_are_marked() {
    for_fours(|a, _| {
        let (units, are_units) = Vector3x4::new(a).normalized();
        let in_range = |v: DVec3| (1e-280..=1e280).contains(&v.dot(v));
        assert_eq!(are_units.to_bitmask(), bits(|i| in_range(a[i])), "{a:?}");
        let marked = units.or(are_units, Vector3x4::splat(DVec3::ZERO));
        let scalar = a.map(|v| normalized(v).filter(|_| in_range(v)).unwrap_or_default());
        assert_same_vectors(marked, scalar);
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
        assert_eq!(mask.to_bitmask(), chosen);
        assert_eq!((!mask).to_bitmask(), 15 - chosen);
        assert_eq!(mask.all(), chosen == 15);
        for (i, lane) in mask.to_array().into_iter().enumerate() {
            assert_eq!(lane.to_bits(), if is_chosen(i) { u64::MAX } else { 0 });
        }
        for_fours(|a, b| {
            let (v, w) = (Vector3x4::new(a), Vector3x4::new(b));
            let either = vectors(|i| if is_chosen(i) { a[i] } else { b[i] });
            assert_kept(v.or(mask, w), either);
            let x = select(mask, v.x, w.x);
            assert_kept(Vector3x4 { x, ..v.or(mask, w) }, either);
            let turned = vectors(|i| if is_chosen(i) { -a[i] } else { a[i] });
            assert_kept(v.negated(mask), turned);
            // A mask also makes a channel black, and a `t` NaN.
            let shown = lanes(|i| if is_chosen(i) { a[i].x } else { 0.0 });
            assert_same(v.x & mask, shown);
            let removed = lanes(|i| if is_chosen(i) { f64::NAN } else { a[i].x });
            assert_same(v.x | mask, removed);
        });
    }
}

#[test]
fn nan_is_neither_less_nor_greater_nor_equal() {
    for_four_numbers(|a, b| {
        let (v, w) = (Lanes::new(a), Lanes::new(b));
        assert_eq!(v.simd_lt(w).to_bitmask(), bits(|i| a[i] < b[i]));
        assert_eq!(v.simd_le(w).to_bitmask(), bits(|i| a[i] <= b[i]));
        assert_eq!(v.simd_gt(w).to_bitmask(), bits(|i| a[i] > b[i]));
        assert_eq!(v.simd_ge(w).to_bitmask(), bits(|i| a[i] >= b[i]));
        assert_eq!(v.simd_eq(w).to_bitmask(), bits(|i| a[i] == b[i]));
        assert_eq!(v.is_nan().to_bitmask(), bits(|i| a[i].is_nan()));
    });
}

/// Neither scalars nor lanes define which of 0 and -0 is the greater.
#[test]
fn max_and_min_drop_a_single_nan() {
    let no_sign = |x: f64| if x == 0.0 { 0.0 } else { x };
    for_four_numbers(|a, b| {
        let (v, w) = (Lanes::new(a), Lanes::new(b));
        let (max, min) = (lanes(|i| a[i].max(b[i])), lanes(|i| a[i].min(b[i])));
        let without_signs = |lanes: Lanes| Lanes::new(lanes.to_array().map(no_sign));
        assert_same(without_signs(v.max(w)), max.map(no_sign));
        assert_same(without_signs(v.min(w)), min.map(no_sign));
        // The fast ones are undefined where there is a NaN.
        let (nan, none) = (v.is_nan() | w.is_nan(), Lanes::ZERO);
        let known = |fast: Lanes| without_signs(select(nan, none, fast));
        let is_nan = |i: usize| a[i].is_nan() || b[i].is_nan();
        let expected = |one: [f64; 4]| lanes(|i| if is_nan(i) { 0.0 } else { no_sign(one[i]) });
        assert_same(known(v.fast_max(w)), expected(max));
        assert_same(known(v.fast_min(w)), expected(min));
    });
}

#[test]
fn roots_quotients_and_magnitudes_have_the_bits_of_single_numbers() {
    for_four_numbers(|a, b| {
        let (v, w) = (Lanes::new(a), Lanes::new(b));
        assert_same(v.sqrt(), a.map(f64::sqrt));
        assert_same(v.abs(), a.map(f64::abs));
        assert_same(v / w, lanes(|i| a[i] / b[i]));
        assert_same(copysign(v, w), lanes(|i| a[i].copysign(b[i])));
    });
}

#[test]
fn the_first_t_ahead_is_the_same_as_for_one_ray() {
    for_four_numbers(|a, b| {
        let scalar = lanes(|i| {
            let ahead = [a[i], b[i]].into_iter().find(|t| *t > 0.0);
            ahead.unwrap_or(f64::NAN)
        });
        assert_same(first_positive(Lanes::new(a), Lanes::new(b)), scalar);
    });
}

#[test]
fn the_largest_coordinate_is_the_same_as_for_one_point() {
    for_fours(|a, _| {
        if a.iter().all(|v| !v.is_nan()) {
            let scalar = a.map(largest_coordinate);
            assert_same(Vector3x4::new(a).largest_coordinate(), scalar);
        }
    });
}
