//! Lanes: four numbers side by side, on which one instruction works.
//!
//! Each lane goes through the operations of the scalar formula, in their order, and
//! so has the same bits.

mod color;
mod ray_packet;
#[cfg(test)]
mod tests;
mod vector;

pub use color::ColorPacket;
pub use ray_packet::{OFFSET, PacketHit, RayPacket};
pub use vector::Vector3x4;

/// Four numbers side by side. A comparison of them yields a mask: all bits of a lane
/// are set, or none.
pub use wide::f64x4 as Lanes;

/// The `t` of no hit.
pub const NO_HIT: Lanes = Lanes::new([f64::NAN; 4]);

/// The values four by four; in the last four the last value repeats.
#[inline]
pub fn in_fours<T: Copy>(values: &[T]) -> impl Iterator<Item = [T; 4]> {
    let lane_of = |four: &[T], lane: usize| four[lane.min(four.len() - 1)];
    values
        .chunks(4)
        .map(move |four| [0, 1, 2, 3].map(|lane| lane_of(four, lane)))
}

/// `yes` in the lanes of the mask, and `no` in the others.
#[inline]
pub fn select(mask: Lanes, yes: Lanes, no: Lanes) -> Lanes {
    mask.bitselect(yes, no)
}

/// `t`, and NaN in the lanes of the mask.
#[inline]
pub fn without(mask: Lanes, t: Lanes) -> Lanes {
    // A number with all bits set is NaN.
    t | mask
}

/// Whether squared lengths of directions are in the range from which formulas may compute.
#[inline]
pub fn is_square_for_formulas(squared: Lanes) -> Lanes {
    squared.simd_ge(Lanes::splat(1e-40)) & squared.simd_le(Lanes::splat(1e40))
}

/// The greatest powers of two that are not above the magnitudes of some numbers.
#[inline]
pub fn powers_of_two(numbers: Lanes) -> Lanes {
    // The bits of infinity are those of the exponent.
    (numbers & Lanes::splat(f64::INFINITY)).fast_max(Lanes::splat(f64::MIN_POSITIVE))
}

/// `t` where it is above 0, else NaN.
#[inline]
pub fn positive(t: Lanes) -> Lanes {
    without(t.simd_le(Lanes::ZERO), t)
}

/// The first of two `t` in ascending order that is above 0, else NaN.
#[inline]
pub fn first_positive(near: Lanes, far: Lanes) -> Lanes {
    select(near.simd_gt(Lanes::ZERO), near, positive(far))
}

/// The magnitudes of some numbers with the signs of others.
#[inline]
pub fn copysign(magnitude: Lanes, sign: Lanes) -> Lanes {
    magnitude.abs() | (sign & Lanes::splat(-0.0))
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

/// The mask of the lanes whose bits are set, the lowest bit standing for the first.
#[inline]
pub fn mask(bits: u32) -> Lanes {
    MASKS[bits as usize & 0b1111]
}

const MASKS: [Lanes; 16] = {
    let mut masks = [Lanes::ZERO; 16];
    let mut bits = 0;
    while bits < 16 {
        let mut lanes = [0.0; 4];
        let mut lane = 0;
        while lane < 4 {
            if is_set(bits, lane) {
                lanes[lane] = f64::from_bits(u64::MAX);
            }
            lane += 1;
        }
        masks[bits as usize] = Lanes::new(lanes);
        bits += 1;
    }
    masks
};
