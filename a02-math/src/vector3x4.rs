//! `Vector3x4`: four vectors side by side, so that one instruction serves all.
//!
//! Each lane goes through the operations of `Vector3`, in their order, and so has
//! the same bits. Points, vectors and normals are one type here: this is how the
//! fast parts of later stages compute, not how anybody should think.

use std::ops::{Add, Mul, Neg, Sub};

use glam::DVec3;

/// Four numbers side by side. What a comparison of them yields is a mask: all
/// bits of a lane are set, or none.
pub use wide::f64x4 as Lanes;

/// Four vectors, coordinate by coordinate.
#[derive(Clone, Copy, Debug)]
pub struct Vector3x4 {
    /// To the right.
    pub x: Lanes,
    /// Upwards.
    pub y: Lanes,
    /// Towards the reader.
    pub z: Lanes,
}

impl Vector3x4 {
    /// The same vector four times.
    #[inline]
    #[must_use]
    pub fn splat(v: DVec3) -> Self {
        Self {
            x: Lanes::splat(v.x),
            y: Lanes::splat(v.y),
            z: Lanes::splat(v.z),
        }
    }

    /// These four vectors.
    #[inline]
    #[must_use]
    pub fn new([a, b, c, d]: [DVec3; 4]) -> Self {
        Self {
            x: Lanes::new([a.x, b.x, c.x, d.x]),
            y: Lanes::new([a.y, b.y, c.y, d.y]),
            z: Lanes::new([a.z, b.z, c.z, d.z]),
        }
    }

    /// The four vectors, one by one.
    #[inline]
    #[must_use]
    pub fn to_lanes(self) -> [DVec3; 4] {
        let (x, y, z) = (self.x.to_array(), self.y.to_array(), self.z.to_array());
        let lane = |lane: usize| DVec3::new(x[lane], y[lane], z[lane]);
        [lane(0), lane(1), lane(2), lane(3)]
    }

    /// The four dot products.
    #[inline]
    #[must_use]
    pub fn dot(self, other: Self) -> Lanes {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// The vectors of length 1 in the same directions, and a mask of those for
    /// which this is true: where `Vector3::normalized` would have to scale, or has
    /// none, lanes hold anything.
    #[inline]
    #[must_use]
    pub fn normalized(self) -> (Self, Lanes) {
        let squared = self.dot(self);
        let length = squared.sqrt();
        let unit = Self {
            x: self.x / length,
            y: self.y / length,
            z: self.z / length,
        };
        (unit, is_square_of_a_length(squared))
    }

    /// The greatest magnitude among the coordinates of each; anything in lanes where
    /// one of them is NaN.
    #[inline]
    #[must_use]
    pub fn largest_coordinate(self) -> Lanes {
        let (x, y, z) = (self.x.abs(), self.y.abs(), self.z.abs());
        x.fast_max(y).fast_max(z)
    }

    /// The vectors of `self` in the lanes of the mask, and of `other` beside it.
    #[inline]
    #[must_use]
    pub fn or(self, mask: Lanes, other: Self) -> Self {
        Self {
            x: select(mask, self.x, other.x),
            y: select(mask, self.y, other.y),
            z: select(mask, self.z, other.z),
        }
    }

    /// These vectors, which point away from surfaces, reflected on their normals:
    /// `2 (n · v) n - v`.
    #[inline]
    #[must_use]
    pub fn reflected_on(self, n: Self) -> Self {
        n * (Lanes::splat(2.0) * n.dot(self)) - self
    }

    /// Negated in the lanes of the mask.
    #[inline]
    #[must_use]
    pub fn negated(self, mask: Lanes) -> Self {
        let sign = mask & Lanes::splat(-0.0);
        Self {
            x: self.x ^ sign,
            y: self.y ^ sign,
            z: self.z ^ sign,
        }
    }
}

/// Whether squares are in the range in which the length is their root.
#[inline]
#[must_use]
pub fn is_square_of_a_length(squared: Lanes) -> Lanes {
    squared.simd_ge(Lanes::splat(1e-280)) & squared.simd_le(Lanes::splat(1e280))
}

/// `yes` in the lanes of the mask, and `no` beside it.
#[inline]
#[must_use]
pub fn select(mask: Lanes, yes: Lanes, no: Lanes) -> Lanes {
    mask.bitselect(yes, no)
}

/// The mask of the lanes whose bits are set, the lowest for the first.
#[inline]
#[must_use]
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
            if bits >> lane & 1 != 0 {
                lanes[lane] = f64::from_bits(u64::MAX);
            }
            lane += 1;
        }
        masks[bits] = Lanes::new(lanes);
        bits += 1;
    }
    masks
};

impl Add for Vector3x4 {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self {
            x: self.x + other.x,
            y: self.y + other.y,
            z: self.z + other.z,
        }
    }
}

impl Sub for Vector3x4 {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self {
            x: self.x - other.x,
            y: self.y - other.y,
            z: self.z - other.z,
        }
    }
}

impl Mul<Lanes> for Vector3x4 {
    type Output = Self;

    #[inline]
    fn mul(self, factor: Lanes) -> Self {
        Self {
            x: self.x * factor,
            y: self.y * factor,
            z: self.z * factor,
        }
    }
}

impl Neg for Vector3x4 {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self {
            x: -self.x,
            y: -self.y,
            z: -self.z,
        }
    }
}
