//! `ColorPacket`: four colours side by side.

use std::ops::{Add, Mul};

use common::Color;

use super::Lanes;

/// Four colours, channel by channel.
#[derive(Clone, Copy, Debug)]
pub struct ColorPacket {
    /// Red.
    pub r: Lanes,
    /// Green.
    pub g: Lanes,
    /// Blue.
    pub b: Lanes,
}

impl ColorPacket {
    /// The same colour four times.
    #[inline]
    pub fn splat(color: Color) -> Self {
        Self {
            r: Lanes::splat(color.r),
            g: Lanes::splat(color.g),
            b: Lanes::splat(color.b),
        }
    }

    /// These four colours.
    #[inline]
    pub fn new([a, b, c, d]: [Color; 4]) -> Self {
        Self {
            r: Lanes::new([a.r, b.r, c.r, d.r]),
            g: Lanes::new([a.g, b.g, c.g, d.g]),
            b: Lanes::new([a.b, b.b, c.b, d.b]),
        }
    }

    /// The four colours, one by one.
    #[inline]
    pub fn to_lanes(self) -> [Color; 4] {
        let (r, g, b) = (self.r.to_array(), self.g.to_array(), self.b.to_array());
        let lane = |lane: usize| Color::new(r[lane], g[lane], b[lane]);
        [lane(0), lane(1), lane(2), lane(3)]
    }

    /// A bit for each that is black.
    #[inline]
    pub fn are_black(self) -> u32 {
        let is_black = |channel: Lanes| channel.simd_eq(Lanes::ZERO);
        (is_black(self.r) & is_black(self.g) & is_black(self.b)).to_bitmask()
    }

    /// These colours in the lanes of the mask, and black in the others.
    #[inline]
    pub fn masked(self, mask: Lanes) -> Self {
        Self {
            r: self.r & mask,
            g: self.g & mask,
            b: self.b & mask,
        }
    }
}

impl Add for ColorPacket {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self {
            r: self.r + other.r,
            g: self.g + other.g,
            b: self.b + other.b,
        }
    }
}

/// Light of four colours, each filtered by one of the others.
impl Mul for ColorPacket {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        Self {
            r: self.r * other.r,
            g: self.g * other.g,
            b: self.b * other.b,
        }
    }
}

impl Mul<Lanes> for ColorPacket {
    type Output = Self;

    #[inline]
    fn mul(self, factor: Lanes) -> Self {
        Self {
            r: self.r * factor,
            g: self.g * factor,
            b: self.b * factor,
        }
    }
}
