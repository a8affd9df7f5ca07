//! Lanes: four numbers side by side, on which one instruction works.
//!
//! Each lane goes through the operations of the scalar formula, in their order, and
//! so has the same bits.
//!
//! `S` stands for the instructions of a processor, which [`level`] chooses when the program runs:
//! `Lanes<Avx2>` are one register, `Lanes<Sse2>` two. A value of `S` is a proof that the processor has the
//! instructions; each `Lanes<S>` holds one, `simd`, of no size.
//!
//! The compiler uses instructions that not every processor has only inside a call of
//! `simd.vectorize`, and in the functions that become a part of it. So every function on lanes is
//! `inline(always)`, also a closure, and one that must not be inlined begins with `vectorize` anew. An
//! operation that is missed is right, but a call. The compiler inlines no closure of `array::map`, for example.

mod color;
pub mod level;
mod ray_packet;
#[cfg(test)]
mod tests;
mod vector;

pub use color::ColorPacket;
pub use fearless_simd::{Simd, f64x4 as Lanes, mask64x4 as Mask};
pub use ray_packet::{OFFSET, PacketHit, RayPacket};
pub use vector::Vector3x4;

use fearless_simd::prelude::*;
use fearless_simd::u64x4;

/// These four numbers.
#[inline(always)]
pub fn lanes<S: Simd>(simd: S, numbers: [f64; 4]) -> Lanes<S> {
    numbers.simd_into(simd)
}

/// The same number four times.
#[inline(always)]
pub fn splat<S: Simd>(simd: S, number: f64) -> Lanes<S> {
    number.simd_into(simd)
}

/// The columns of four rows.
#[inline(always)]
pub fn transposed<S: Simd>([a, b, c, d]: [Lanes<S>; 4]) -> [Lanes<S>; 4] {
    let (low_a, high_a) = a.split();
    let (low_b, high_b) = b.split();
    let (low_c, high_c) = c.split();
    let (low_d, high_d) = d.split();
    [
        low_a.zip_low(low_b).combine(low_c.zip_low(low_d)),
        low_a.zip_high(low_b).combine(low_c.zip_high(low_d)),
        high_a.zip_low(high_b).combine(high_c.zip_low(high_d)),
        high_a.zip_high(high_b).combine(high_c.zip_high(high_d)),
    ]
}

/// The `t` of no hit.
#[inline(always)]
pub fn no_hit<S: Simd>(simd: S) -> Lanes<S> {
    splat(simd, f64::NAN)
}

/// The values four by four; in the last four the last value repeats.
#[inline]
pub fn in_fours<T: Copy>(values: &[T]) -> impl Iterator<Item = [T; 4]> {
    let lane_of = |four: &[T], lane: usize| four[lane.min(four.len() - 1)];
    values
        .chunks(4)
        .map(move |four| [0, 1, 2, 3].map(|lane| lane_of(four, lane)))
}

/// `t`, and NaN in the lanes of the mask.
#[inline(always)]
pub fn without<S: Simd>(mask: Mask<S>, t: Lanes<S>) -> Lanes<S> {
    mask.select(no_hit(t.simd), t)
}

/// Whether squared lengths of directions are in the range from which formulas may compute.
#[inline(always)]
pub fn is_square_for_formulas<S: Simd>(squared: Lanes<S>) -> Mask<S> {
    squared.simd_ge(1e-40) & squared.simd_le(1e40)
}

/// The greatest powers of two that are not above the magnitudes of some numbers.
#[inline(always)]
pub fn powers_of_two<S: Simd>(numbers: Lanes<S>) -> Lanes<S> {
    // The bits of infinity are those of the exponent.
    let exponents = numbers.bitcast::<u64x4<S>>() & f64::INFINITY.to_bits();
    greater(exponents.bitcast(), splat(numbers.simd, f64::MIN_POSITIVE))
}

/// `t` where it is above 0, else NaN.
#[inline(always)]
pub fn positive<S: Simd>(t: Lanes<S>) -> Lanes<S> {
    without(t.simd_le(0.0), t)
}

/// The first of two `t` in ascending order that is above 0, else NaN.
#[inline(always)]
pub fn first_positive<S: Simd>(near: Lanes<S>, far: Lanes<S>) -> Lanes<S> {
    near.simd_gt(0.0).select(near, positive(far))
}

/// The greater of two numbers; the second one if either is NaN, or if both are zeros. (The crate's
/// `max` takes another one of these on some processors.)
#[inline(always)]
pub fn greater<S: Simd>(a: Lanes<S>, b: Lanes<S>) -> Lanes<S> {
    a.simd_gt(b).select(a, b)
}

/// The lesser of two numbers; the second one if either is NaN, or if both are zeros.
#[inline(always)]
pub fn lesser<S: Simd>(a: Lanes<S>, b: Lanes<S>) -> Lanes<S> {
    a.simd_lt(b).select(a, b)
}

/// A bit for each lane of the mask, the lowest one for the first lane.
#[inline(always)]
pub fn bits_of<S: Simd>(mask: Mask<S>) -> u32 {
    mask.to_bitmask() as u32
}

/// The mask of the lanes whose bits are set, the lowest bit standing for the first.
#[inline(always)]
pub fn mask<S: Simd>(simd: S, bits: u32) -> Mask<S> {
    Mask::from_bitmask(simd, u64::from(bits & 0b1111))
}

/// The numbers of the lanes whose bits are set.
#[inline]
pub fn bits(mut mask: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let bit = mask.trailing_zeros() as usize;
        (mask != 0).then(|| {
            mask &= mask - 1;
            bit
        })
    })
}

/// Whether the bit of a lane is set.
#[inline]
pub const fn is_set(mask: u32, lane: usize) -> bool {
    mask >> lane & 1 != 0
}
