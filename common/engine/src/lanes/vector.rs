//! `Vector3x4`: four vectors side by side. Points, vectors and normals are one type
//! here.

use std::ops::{Add, Mul, Neg, Sub};

use fearless_simd::prelude::*;
use glam::DVec3;

use super::{Lanes, Mask, lanes, mask, splat};

/// Four vectors, coordinate by coordinate.
#[derive(Clone, Copy, Debug)]
pub struct Vector3x4<S: Simd> {
    /// To the right.
    pub x: Lanes<S>,
    /// Upwards.
    pub y: Lanes<S>,
    /// Towards the reader.
    pub z: Lanes<S>,
}

impl<S: Simd> Vector3x4<S> {
    /// The same vector four times.
    #[inline(always)]
    pub fn splat(simd: S, v: DVec3) -> Self {
        Self {
            x: splat(simd, v.x),
            y: splat(simd, v.y),
            z: splat(simd, v.z),
        }
    }

    /// These four vectors.
    #[inline(always)]
    pub fn new(simd: S, [a, b, c, d]: [DVec3; 4]) -> Self {
        Self {
            x: lanes(simd, [a.x, b.x, c.x, d.x]),
            y: lanes(simd, [a.y, b.y, c.y, d.y]),
            z: lanes(simd, [a.z, b.z, c.z, d.z]),
        }
    }

    /// The four vectors, one by one.
    #[inline(always)]
    pub fn to_lanes(self) -> [DVec3; 4] {
        let lane = |lane: usize| DVec3::new(self.x[lane], self.y[lane], self.z[lane]);
        [lane(0), lane(1), lane(2), lane(3)]
    }

    /// The coordinates along each axis.
    #[inline(always)]
    pub fn axes(self) -> [Lanes<S>; 3] {
        [self.x, self.y, self.z]
    }

    /// The four dot products.
    #[inline(always)]
    pub fn dot(self, other: Self) -> Lanes<S> {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// The magnitudes of all coordinates.
    #[inline(always)]
    pub fn abs(self) -> Self {
        Self {
            x: self.x.abs(),
            y: self.y.abs(),
            z: self.z.abs(),
        }
    }

    /// The vectors of length 1 in the same directions, and a mask of the lanes that
    /// hold them. The other lanes hold anything: the scalar formula has to scale their
    /// vectors first, or they have no direction.
    #[inline(always)]
    pub fn normalized(self) -> (Self, Mask<S>) {
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
    #[inline(always)]
    pub fn largest_coordinate(self) -> Lanes<S> {
        let Self { x, y, z } = self.abs();
        x.max(y).max(z)
    }

    /// The lesser of the coordinates of each.
    #[inline(always)]
    pub fn min(self, other: Self) -> Self {
        Self {
            x: self.x.min(other.x),
            y: self.y.min(other.y),
            z: self.z.min(other.z),
        }
    }

    /// The greater of the coordinates of each.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        Self {
            x: self.x.max(other.x),
            y: self.y.max(other.y),
            z: self.z.max(other.z),
        }
    }

    /// The vectors of `self` in the lanes of the mask, and of `other` in the others.
    #[inline(always)]
    pub fn or(self, mask: Mask<S>, other: Self) -> Self {
        Self {
            x: mask.select(self.x, other.x),
            y: mask.select(self.y, other.y),
            z: mask.select(self.z, other.z),
        }
    }

    /// These vectors, where the first active one replaces those that are not active.
    #[inline(always)]
    pub fn filled(self, active: u32) -> Self {
        let simd = self.x.simd;
        let first = active.trailing_zeros() as usize % 4;
        let first = DVec3::new(self.x[first], self.y[first], self.z[first]);
        self.or(mask(simd, active), Self::splat(simd, first))
    }

    /// These vectors, which point away from surfaces, reflected on their normals:
    /// `2 (n · v) n - v`.
    #[inline(always)]
    pub fn reflected_on(self, n: Self) -> Self {
        n * (2.0 * n.dot(self)) - self
    }

    /// Negated in the lanes of the mask.
    #[inline(always)]
    pub fn negated(self, mask: Mask<S>) -> Self {
        (-self).or(mask, self)
    }
}

/// Whether squared lengths are in the range in which the root is the length.
#[inline(always)]
pub fn is_square_of_a_length<S: Simd>(squared: Lanes<S>) -> Mask<S> {
    squared.simd_ge(1e-280) & squared.simd_le(1e280)
}

impl<S: Simd> Add for Vector3x4<S> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            x: self.x + other.x,
            y: self.y + other.y,
            z: self.z + other.z,
        }
    }
}

impl<S: Simd> Sub for Vector3x4<S> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self {
            x: self.x - other.x,
            y: self.y - other.y,
            z: self.z - other.z,
        }
    }
}

impl<S: Simd> Mul<Lanes<S>> for Vector3x4<S> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: Lanes<S>) -> Self {
        Self {
            x: self.x * factor,
            y: self.y * factor,
            z: self.z * factor,
        }
    }
}

impl<S: Simd> Neg for Vector3x4<S> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self {
            x: -self.x,
            y: -self.y,
            z: -self.z,
        }
    }
}
