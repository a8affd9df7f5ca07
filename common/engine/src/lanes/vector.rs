//! `Vector3x4`: four vectors side by side. Points, vectors and normals are one type
//! here.

use std::ops::{Add, Mul, Neg, Sub};

use glam::DVec3;

use super::{Lanes, select};

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
    pub fn splat(v: DVec3) -> Self {
        Self {
            x: Lanes::splat(v.x),
            y: Lanes::splat(v.y),
            z: Lanes::splat(v.z),
        }
    }

    /// These four vectors.
    #[inline]
    pub fn new([a, b, c, d]: [DVec3; 4]) -> Self {
        Self {
            x: Lanes::new([a.x, b.x, c.x, d.x]),
            y: Lanes::new([a.y, b.y, c.y, d.y]),
            z: Lanes::new([a.z, b.z, c.z, d.z]),
        }
    }

    /// The four vectors, one by one.
    #[inline]
    pub fn to_lanes(self) -> [DVec3; 4] {
        let (x, y, z) = (self.x.to_array(), self.y.to_array(), self.z.to_array());
        let lane = |lane: usize| DVec3::new(x[lane], y[lane], z[lane]);
        [lane(0), lane(1), lane(2), lane(3)]
    }

    /// The four dot products.
    #[inline]
    pub fn dot(self, other: Self) -> Lanes {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// The magnitudes of all coordinates.
    #[inline]
    pub fn abs(self) -> Self {
        let Self { x, y, z } = self;
        let [x, y, z] = [x, y, z].map(Lanes::abs);
        Self { x, y, z }
    }

    /// The vectors of length 1 in the same directions, and a mask of the lanes that
    /// hold them. The other lanes hold anything: the scalar formula has to scale their
    /// vectors first, or they have no direction.
    #[inline]
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

    /// The greatest magnitude among the coordinates of each; lanes with a NaN hold
    /// anything.
    #[inline]
    pub fn largest_coordinate(self) -> Lanes {
        let Self { x, y, z } = self.abs();
        x.fast_max(y).fast_max(z)
    }

    /// The lesser of the coordinates of each.
    #[inline]
    pub fn min(self, other: Self) -> Self {
        Self {
            x: self.x.fast_min(other.x),
            y: self.y.fast_min(other.y),
            z: self.z.fast_min(other.z),
        }
    }

    /// The greater of the coordinates of each.
    #[inline]
    pub fn max(self, other: Self) -> Self {
        Self {
            x: self.x.fast_max(other.x),
            y: self.y.fast_max(other.y),
            z: self.z.fast_max(other.z),
        }
    }

    /// The vectors of `self` in the lanes of the mask, and of `other` in the others.
    #[inline]
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
    pub fn reflected_on(self, n: Self) -> Self {
        n * (Lanes::splat(2.0) * n.dot(self)) - self
    }

    /// Negated in the lanes of the mask.
    #[inline]
    pub fn negated(self, mask: Lanes) -> Self {
        let sign = mask & Lanes::splat(-0.0);
        Self {
            x: self.x ^ sign,
            y: self.y ^ sign,
            z: self.z ^ sign,
        }
    }
}

/// Whether squared lengths are in the range in which the root is the length.
#[inline]
pub fn is_square_of_a_length(squared: Lanes) -> Lanes {
    squared.simd_ge(Lanes::splat(1e-280)) & squared.simd_le(Lanes::splat(1e280))
}

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
