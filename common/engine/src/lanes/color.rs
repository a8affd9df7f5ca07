//! `ColorPacket`: four colours side by side.

use std::ops::{Add, Mul};

use common::Color;
use fearless_simd::prelude::*;

use super::{Lanes, Mask, bits_of, lanes, splat};

/// Four colours, channel by channel.
#[derive(Clone, Copy, Debug)]
pub struct ColorPacket<S: Simd> {
    /// Red.
    pub r: Lanes<S>,
    /// Green.
    pub g: Lanes<S>,
    /// Blue.
    pub b: Lanes<S>,
}

impl<S: Simd> ColorPacket<S> {
    /// The same colour four times.
    #[inline(always)]
    pub fn splat(simd: S, color: Color) -> Self {
        Self {
            r: splat(simd, color.r),
            g: splat(simd, color.g),
            b: splat(simd, color.b),
        }
    }

    /// These four colours.
    #[inline(always)]
    pub fn new(simd: S, [a, b, c, d]: [Color; 4]) -> Self {
        Self {
            r: lanes(simd, [a.r, b.r, c.r, d.r]),
            g: lanes(simd, [a.g, b.g, c.g, d.g]),
            b: lanes(simd, [a.b, b.b, c.b, d.b]),
        }
    }

    /// The four colours, one by one.
    #[inline(always)]
    pub fn to_lanes(self) -> [Color; 4] {
        let lane = |lane: usize| Color::new(self.r[lane], self.g[lane], self.b[lane]);
        [lane(0), lane(1), lane(2), lane(3)]
    }

    /// A bit for each that is black.
    #[inline(always)]
    pub fn are_black(self) -> u32 {
        bits_of(self.r.simd_eq(0.0) & self.g.simd_eq(0.0) & self.b.simd_eq(0.0))
    }

    /// These colours in the lanes of the mask, and black in the others.
    #[inline(always)]
    pub fn masked(self, mask: Mask<S>) -> Self {
        let black = splat(self.r.simd, 0.0);
        Self {
            r: mask.select(self.r, black),
            g: mask.select(self.g, black),
            b: mask.select(self.b, black),
        }
    }
}

impl<S: Simd> Add for ColorPacket<S> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            r: self.r + other.r,
            g: self.g + other.g,
            b: self.b + other.b,
        }
    }
}

/// Light of four colours, each filtered by one of the others.
impl<S: Simd> Mul for ColorPacket<S> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self {
            r: self.r * other.r,
            g: self.g * other.g,
            b: self.b * other.b,
        }
    }
}

impl<S: Simd> Mul<Lanes<S>> for ColorPacket<S> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: Lanes<S>) -> Self {
        Self {
            r: self.r * factor,
            g: self.g * factor,
            b: self.b * factor,
        }
    }
}
