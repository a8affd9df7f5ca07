//! `Cell`: a square of the picture, of which the light at its corners is known.
//!
//! The light within is taken for the mean of that at the corners, or nearly so. Two
//! things tell how far off this may be:
//!
//! - What the corners show. Where an edge crosses the cell, some lie on one side of
//!   it and some on the other, and the light on both sides is theirs.
//! - What lies around. Where light bends from cell to cell, something may hide in a
//!   cell whose corners look even. How often it does, only dividing such cells
//!   tells: see [`Experience`](super::experience::Experience).

use crate::lanes::Lanes;
use common::Color;

use super::place::Place;

/// A block of 4 x 4 pixels, or what it was divided into.
#[derive(Clone, Copy, Debug)]
pub struct Cell {
    /// The light at its corners: left and right above, left and right below.
    pub corners: [Color; 4],
    /// Its upper left corner, in units of the smallest cells.
    pub x: u32,
    pub y: u32,
    /// By how much its corners differ, squared and summed over pixels and channels.
    pub seen: f32,
    /// The same of how far the light around bends: as much it could hide.
    pub hidden: f32,
    /// How far the light around is from changing evenly, in any channel.
    pub bend: f32,
    /// How often a block was divided to come to it.
    pub depth: u8,
}

/// The light that divides a cell: in the middle of its upper side, on its left, in
/// its own middle, on its right and below.
pub type Cross = [Color; 5];

/// The side of a block, in pixels.
pub const BLOCK: u32 = 4;
/// How often a block is divided to come to its pixels.
pub const PIXEL_DEPTH: u8 = BLOCK.ilog2() as u8;
/// How often a block is divided at most.
pub const DEEPEST: u8 = 10;
/// The side of a pixel, in units of the smallest cells.
pub const PIXEL: u32 = 1 << (DEEPEST - PIXEL_DEPTH);

/// So much of what was seen to bend around a cell bends around its parts, whatever
/// is seen of them.
const AROUND_PARTS: f32 = 0.5;

impl Cell {
    /// The cell that begins with the pixel in this column and row, where light bends by
    /// so much.
    pub fn new((x, y): (u32, u32), depth: u8, corners: [Color; 4], bend: f32) -> Self {
        let (seen, hidden) = squares(corners.map(lanes), bend, weight(depth));
        Self {
            corners,
            x: x * PIXEL,
            y: y * PIXEL,
            seen,
            hidden,
            bend,
            depth,
        }
    }

    #[cfg(test)]
    pub fn block(x: u32, y: u32, corners: [Color; 4], bend: f32) -> Self {
        Self::new((x, y), 0, corners, bend)
    }

    /// Whether its corners show next to nothing of what is around.
    pub fn looks_even(&self) -> bool {
        self.seen < 0.01 * self.hidden
    }

    /// The column and row of the pixel that it begins in.
    pub const fn pixel(&self) -> (u32, u32) {
        (self.x / PIXEL, self.y / PIXEL)
    }

    /// Its area, in pixels.
    pub fn area(&self) -> f64 {
        area(self.depth)
    }

    /// Its light.
    pub fn light(&self) -> Color {
        let [r, g, b, _] = light(self.corners.map(lanes)).to_array();
        Color::new(r, g, b)
    }

    /// By how much its corners differ, in any channel.
    pub fn contrast(&self) -> f32 {
        let [least, _, _, most] = ranked(self.corners.map(lanes));
        greatest_channel(most - least)
    }

    const fn side(&self) -> u32 {
        (BLOCK * PIXEL) >> self.depth
    }

    /// Where its cross is.
    pub const fn places(&self) -> [Place; 5] {
        let Self { x, y, .. } = *self;
        let (half, side) = (self.side() / 2, self.side());
        [
            (x + half, y),
            (x, y + half),
            (x + half, y + half),
            (x + side, y + half),
            (x + half, y + side),
        ]
    }

    /// Its four parts: left and right above, left and right below.
    #[inline]
    pub fn divided(&self, cross: &Cross) -> [Self; 4] {
        let (corners, middles) = (self.corners.map(lanes), cross.map(lanes));
        let bend = bend(corners, middles).max(AROUND_PARTS * self.bend);
        let (half, depth) = (self.side() / 2, self.depth + 1);
        let colors = quarters(self.corners, *cross);
        let lanes = quarters(corners, middles);
        let part = |i: usize, right: u32, down: u32| {
            let (seen, hidden) = squares(lanes[i], bend, weight(depth));
            Self {
                corners: colors[i],
                x: self.x + right * half,
                y: self.y + down * half,
                seen,
                hidden,
                bend,
                depth,
            }
        };
        [part(0, 0, 0), part(1, 1, 0), part(2, 0, 1), part(3, 1, 1)]
    }
}

/// How far the light is from the mean of the corners to that of the two between the
/// darkest and the brightest.
///
/// Where light changes evenly both are the same, and where an edge has two corners on
/// each side. Where it cuts off one, that has a quarter of the mean, and of all
/// straight lines that do, the area cut off is (ln(1 + r) - 1/r) / (3 (2 - r)) = 0.0991,
/// with the root r of two. (Crofton's measure of lines; see Santaló, Integral Geometry
/// and Geometric Probability, 1976, chapter 3.)
const TO_MIDDLE: f64 = 1.0 - 4.0 * 0.0991;

// ANCHOR: light
/// The light between four corners: of the same ones, exactly that.
#[inline]
fn light([a, b, c, d]: [Lanes; 4]) -> Lanes {
    let mean = ((a + b) + (c + d)) * Lanes::splat(0.25);
    let [_, one, other, _] = ranked([a, b, c, d]);
    let middle = (one + other) * Lanes::splat(0.5);
    let light = mean + (middle - mean) * Lanes::splat(TO_MIDDLE);
    // Where corners have no end, there is no middle.
    light.simd_eq(light).select(light, mean)
}
// ANCHOR_END: light

/// In each channel the least, the two in the middle in any order, and the greatest.
#[inline]
fn ranked([a, b, c, d]: [Lanes; 4]) -> [Lanes; 4] {
    let (low, high) = ([a.min(b), c.min(d)], [a.max(b), c.max(d)]);
    [
        low[0].min(low[1]),
        low[0].max(low[1]),
        high[0].min(high[1]),
        high[0].max(high[1]),
    ]
}

/// The mean of four colours; of the same ones, exactly that.
pub fn mean([a, b, c, d]: [Color; 4]) -> Color {
    ((a + b) + (c + d)) * 0.25
}

/// The area of cells of this depth, in pixels.
fn area(depth: u8) -> f64 {
    f64::from(BLOCK * BLOCK) / f64::from(1_u32 << (2 * depth))
}

/// What the error of a cell counts for: a block stands for its pixels, and a part of a
/// pixel for its area, squared.
pub fn weight(depth: u8) -> f64 {
    let area = area(depth);
    area.min(area * area)
}

/// The corners of the four parts.
#[inline]
const fn quarters<T: Copy>([a, b, c, d]: [T; 4], cross: [T; 5]) -> [[T; 4]; 4] {
    let [above, left, middle, right, below] = cross;
    [
        [a, above, left, middle],
        [above, b, middle, right],
        [left, middle, c, below],
        [middle, right, below, d],
    ]
}

/// How far the light of a cross is from changing evenly between corners: twice the
/// distance from their mean.
#[inline]
fn bend([a, b, c, d]: [Lanes; 4], cross: [Lanes; 5]) -> f32 {
    let [above, left, middle, right, below] = cross;
    let bends = [
        a + b - (above + above),
        a + c - (left + left),
        ((a + b) + (c + d)) * Lanes::splat(0.5) - (middle + middle),
        b + d - (right + right),
        c + d - (below + below),
    ];
    let greatest = |most: Lanes, bend: Lanes| most.max(bend.abs());
    greatest_channel(bends.into_iter().fold(Lanes::ZERO, greatest))
}

/// Where one corner is alone, the squared error counts for so much of that where two
/// are on each side. For straight edges it is less, 0.0109 to 0.0463 of all lines, but
/// a corner alone may be the tip of something, too.
const ONE_CORNER: f64 = 0.5;

/// What corners show, and what may hide between them, both squared.
#[inline]
fn squares(corners: [Lanes; 4], bend: f32, weight: f64) -> (f32, f32) {
    let bend = f64::from(bend);
    if bend == 0.0 {
        return (0.0, 0.0);
    }
    let [least, one, other, most] = ranked(corners);
    let (differing, middle) = (most - least, (other - one).abs());
    // Smooth light may differ much, and yet its mean is that of the corners: it is
    // off by no more than it bends.
    let bends = Lanes::splat(bend);
    let (differing, middle) = (differing.min(bends), middle.min(bends));
    let seen = differing * differing * Lanes::splat(ONE_CORNER)
        + middle * middle * Lanes::splat(1.0 - ONE_CORNER);
    // What is brighter than white is white on the screen.
    let is_white = least.simd_ge(Lanes::ONE);
    let [r, g, b, _] = is_white.select(Lanes::ZERO, seen).to_array();
    let dark = 3 - (is_white.to_bitmask() & 0b111).count_ones();
    let weighted = |square: f64| {
        let square = (weight * square) as f32;
        // What is no number, or has no end, becomes no better by looking.
        if square.is_finite() { square } else { 0.0 }
    };
    (weighted(r + g + b), weighted(f64::from(dark) * bend * bend))
}

/// The greatest of red, green and blue.
#[inline]
pub fn greatest_channel(lanes: Lanes) -> f32 {
    let [r, g, b, _] = lanes.to_array();
    r.max(g).max(b) as f32
}

/// Red, green and blue side by side, so that one instruction serves all.
#[inline]
pub fn lanes(color: Color) -> Lanes {
    Lanes::new([color.r, color.g, color.b, 0.0])
}

#[cfg(test)]
mod tests;
