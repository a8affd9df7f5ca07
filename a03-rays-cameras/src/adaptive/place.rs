//! `Place`: where cells have their corners.

use super::cell::PIXEL;
use crate::PixelRandom;

/// A column and a row of corners in the picture, in units of the smallest cells.
pub type Place = (u32, u32);

/// Where a ray is sent for a place, in pixels from the upper left corner of the
/// picture: a hair beside it, to a side that the seed decides.
///
/// In many pictures an edge lies exactly between two rows of pixels. All corners there
/// would be on its one side, and one of the rows half a pixel off.
pub fn beside((x, y): Place, seed: u64) -> (f64, f64) {
    let random = PixelRandom::new(seed, x, y);
    let near = |at: u32, n| (f64::from(at) + HAIR * (random.uniform(n) - 0.5)) / f64::from(PIXEL);
    (near(x, 0), near(y, 1))
}

/// So wide, in units of the smallest cells.
const HAIR: f64 = 0.5;

/// A place in one number. In the order of these, neighbours are mostly next to each
/// other, as the digits of both coordinates take turns (Morton, A Computer Oriented
/// Geodetic Data Base, 1966).
pub const fn number((x, y): Place) -> u64 {
    spread(x) | spread(y) << 1
}

/// The place of this number.
pub const fn of_number(number: u64) -> Place {
    (gather(number), gather(number >> 1))
}

/// One digit in two.
const fn spread(digits: u32) -> u64 {
    let x = digits as u64;
    let x = (x | x << 16) & 0x0000_FFFF_0000_FFFF;
    let x = (x | x << 8) & 0x00FF_00FF_00FF_00FF;
    let x = (x | x << 4) & 0x0F0F_0F0F_0F0F_0F0F;
    let x = (x | x << 2) & 0x3333_3333_3333_3333;
    (x | x << 1) & 0x5555_5555_5555_5555
}

/// Every second digit.
const fn gather(x: u64) -> u32 {
    let x = x & 0x5555_5555_5555_5555;
    let x = (x | x >> 1) & 0x3333_3333_3333_3333;
    let x = (x | x >> 2) & 0x0F0F_0F0F_0F0F_0F0F;
    let x = (x | x >> 4) & 0x00FF_00FF_00FF_00FF;
    let x = (x | x >> 8) & 0x0000_FFFF_0000_FFFF;
    (x | x >> 16) as u32
}
