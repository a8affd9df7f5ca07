//! Four rays at a time: what `Geometry::hit` answers to each of them.
//!
//! Every lane goes through the operations of the shape's own formula, in their
//! order, and so has the same answer to the last bit. Where that formula branches,
//! both ways are computed and one is chosen.

mod axis_aligned_box;
mod plane;
mod sphere;
mod triangle;

use a02_math::vector3x4::select;
use a02_math::{Lanes, Vector3x4};

pub use triangle::ShearedRays;

/// Up to four hits.
#[derive(Clone, Copy, Debug)]
pub struct PacketHit {
    /// Where on the rays: above 0. NaN where nothing is met.
    pub t: Lanes,
    /// The normals that light is computed with.
    pub normal: Vector3x4,
    /// The normals of the surfaces themselves.
    pub face: Vector3x4,
}

impl PacketHit {
    /// These hits in the lanes of the mask, and the others beside it.
    #[inline]
    pub(crate) fn or(self, mask: Lanes, others: Self) -> Self {
        Self {
            t: select(mask, self.t, others.t),
            normal: self.normal.or(mask, others.normal),
            face: self.face.or(mask, others.face),
        }
    }
}

/// No `t` at all.
const NOWHERE: Lanes = Lanes::new([f64::NAN; 4]);

/// `t`, and NaN in the lanes of the mask.
#[inline]
fn without(mask: Lanes, t: Lanes) -> Lanes {
    // All bits set is one of the NaN.
    t | mask
}

/// `t` where it lies ahead, else NaN.
#[inline]
fn ahead(t: Lanes) -> Lanes {
    without(t.simd_le(Lanes::ZERO), t)
}

/// The first of two `t` in ascending order that lies ahead, else NaN.
#[inline]
fn first_ahead(near: Lanes, far: Lanes) -> Lanes {
    select(near.simd_gt(Lanes::ZERO), near, ahead(far))
}

/// The magnitudes of some numbers with the signs of others.
#[inline]
fn copysign(magnitude: Lanes, sign: Lanes) -> Lanes {
    magnitude.abs() | (sign & Lanes::splat(-0.0))
}
