//! `Color`: linear red, green and blue.
//!
//! Channels are not limited to 0..=1 while light is added up and filtered;
//! they are clamped once, when a picture becomes bytes.
//!
//! Functions that run for every ray are marked `#[inline]`, because few others are inlined across
//! crates.

use std::ops::{Add, AddAssign, Div, Mul, Sub};

/// A colour of linear red, green and blue, nominally from 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Color {
    /// Red.
    pub r: f64,
    /// Green.
    pub g: f64,
    /// Blue.
    pub b: f64,
}

impl Color {
    /// No light at all.
    pub const BLACK: Self = Self::gray(0.0);
    /// All three channels are 1.
    pub const WHITE: Self = Self::gray(1.0);
    /// Full red.
    pub const RED: Self = Self::new(1.0, 0.0, 0.0);
    /// Full green.
    pub const GREEN: Self = Self::new(0.0, 1.0, 0.0);
    /// Full blue.
    pub const BLUE: Self = Self::new(0.0, 0.0, 1.0);
    /// Red and green.
    pub const YELLOW: Self = Self::new(1.0, 1.0, 0.0);
    /// Red and blue.
    pub const MAGENTA: Self = Self::new(1.0, 0.0, 1.0);

    /// The colour of these three channels.
    #[must_use]
    #[inline]
    pub const fn new(r: f64, g: f64, b: f64) -> Self {
        Self { r, g, b }
    }

    /// The grey whose three channels are `value`.
    #[must_use]
    #[inline]
    pub const fn gray(value: f64) -> Self {
        Self::new(value, value, value)
    }

    /// The colour of three bytes, with 255 as 1.
    #[must_use]
    pub fn from_bytes([r, g, b]: [u8; 3]) -> Self {
        Self::new(r.into(), g.into(), b.into()) / 255.0
    }

    /// The colour of a packed 0xRRGGBB number; higher bits are ignored.
    #[must_use]
    pub fn from_packed(rgb: u32) -> Self {
        let [_, r, g, b] = rgb.to_be_bytes();
        Self::from_bytes([r, g, b])
    }

    // ANCHOR: bytes
    /// Three bytes: clamped to 0..=1, scaled to 255 and rounded to the nearest.
    /// NaN becomes 0.
    #[must_use]
    pub fn to_bytes(self) -> [u8; 3] {
        // The cast saturates: it is the clamp.
        self.channels().map(|channel| (channel * 255.0 + 0.5) as u8)
    }
    // ANCHOR_END: bytes

    /// Red, green and blue, in this order.
    #[must_use]
    #[inline]
    pub const fn channels(self) -> [f64; 3] {
        [self.r, self.g, self.b]
    }

    /// The largest channel that is a number, but at least 0.
    #[must_use]
    pub fn largest_channel(self) -> f64 {
        self.channels().into_iter().fold(0.0, f64::max)
    }

    /// The colour with `f` applied to each channel.
    #[must_use]
    #[inline]
    pub fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self::new(f(self.r), f(self.g), f(self.b))
    }

    /// Whether no channel is NaN or infinite.
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.channels().iter().all(|channel| channel.is_finite())
    }
}

impl Add for Color {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.r + other.r, self.g + other.g, self.b + other.b)
    }
}

impl AddAssign for Color {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Sub for Color {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(self.r - other.r, self.g - other.g, self.b - other.b)
    }
}

/// Light of one colour, filtered by the other: channel by channel.
impl Mul for Color {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::new(self.r * other.r, self.g * other.g, self.b * other.b)
    }
}

impl Mul<f64> for Color {
    type Output = Self;

    #[inline]
    fn mul(self, factor: f64) -> Self {
        self.map(|channel| channel * factor)
    }
}

impl Div<f64> for Color {
    type Output = Self;

    #[inline]
    fn div(self, divisor: f64) -> Self {
        self.map(|channel| channel / divisor)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_become_numbers_and_the_same_bytes_again() {
        let packed = Color::from_packed(0xAB12_3456).to_bytes();
        assert_eq!(packed, [0x12, 0x34, 0x56]);
        for byte in 0..=255 {
            let bytes = [byte, 255 - byte, byte / 2];
            assert_eq!(Color::from_bytes(bytes).to_bytes(), bytes);
        }
    }

    /// 49 · (1/49) is below 1.
    #[test]
    fn a_quotient_is_rounded_once() {
        assert_eq!(
            Color::new(49.0, -98.0, 0.0) / 49.0,
            Color::new(1.0, -2.0, 0.0)
        );
    }

    #[test]
    fn bytes_are_clamped_and_rounded() {
        let byte = |channel: f64| Color::gray(channel).to_bytes()[0];
        assert_eq!(byte(1.5), 255);
        assert_eq!(byte(-0.5), 0);
        assert_eq!(byte(f64::INFINITY), 255);
        assert_eq!(byte(f64::NAN), 0);
        assert_eq!(byte(0.5), 128, "127.5 is rounded up");
        assert_eq!(byte(0.999_999), 255);
        assert_eq!(byte(0.5 / 255.0), 1, "half a grey level");
    }
}
