//! `Cell`: a square of the picture, of which the light at its corners is known.
//!
//! The light within is taken for the mean of that at the corners. Two things tell
//! how far off this may be:
//!
//! - What the corners show. Where an edge crosses the cell, some lie on one side of
//!   it and some on the other, and the light on both sides is theirs.
//! - What lies around. Where light bends from cell to cell, something may hide in a
//!   cell whose corners look even. How often it does, only dividing such cells
//!   tells, and see [`Experience`](super::experience::Experience).

use a02_math::Lanes;
use common::Color;

use super::place::Place;

/// A block of 2 x 2 pixels, or what it was divided into.
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
    bend: f32,
    /// How often a block was divided to come to it: 0 is a block, 1 a pixel.
    pub depth: u8,
}

/// The light that divides a cell: in the middle of its upper side, on its left, in
/// its own middle, on its right and below.
pub type Cross = [Color; 5];

/// How often a block is divided at most.
pub const DEEPEST: u8 = 9;
/// The side of a pixel, in units of the smallest cells.
pub const PIXEL: u32 = 1 << (DEEPEST - 1);

/// So much of what was seen to bend around a cell bends around its parts, whatever
/// is seen of them.
const AROUND_PARTS: f32 = 0.5;

impl Cell {
    /// The block that begins with the pixel in this column and row.
    pub fn block(x: u32, y: u32, corners: [Color; 4], bend: f32) -> Self {
        let (seen, hidden) = squares(corners.map(lanes), bend, weight(0));
        Self {
            corners,
            x: x * PIXEL,
            y: y * PIXEL,
            seen,
            hidden,
            bend,
            depth: 0,
        }
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
        4.0 / f64::from(1_u32 << (2 * self.depth))
    }

    /// Its light: the mean of that at the corners.
    pub fn mean(&self) -> Color {
        mean(self.corners)
    }

    const fn side(&self) -> u32 {
        (2 * PIXEL) >> self.depth
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

/// The mean of four colours; of the same ones, exactly that.
pub fn mean([a, b, c, d]: [Color; 4]) -> Color {
    ((a + b) + (c + d)) * 0.25
}

/// What the error of a cell counts for: a block stands for four pixels, and a part of
/// a pixel for its area, squared.
pub fn weight(depth: u8) -> f64 {
    const WEIGHTS: [f64; DEEPEST as usize + 1] = {
        let mut weights = [4.0; DEEPEST as usize + 1];
        let (mut depth, mut weight) = (1, 1.0);
        while depth < weights.len() {
            weights[depth] = weight;
            weight /= 16.0;
            depth += 1;
        }
        weights
    };
    WEIGHTS[usize::from(depth)]
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

/// What corners show, and what may hide between them, both squared.
#[inline]
fn squares([a, b, c, d]: [Lanes; 4], bend: f32, weight: f64) -> (f32, f32) {
    let bend = f64::from(bend);
    if bend == 0.0 {
        return (0.0, 0.0);
    }
    let least = a.min(b).min(c.min(d));
    let differing = a.max(b).max(c.max(d)) - least;
    // Smooth light may differ much, and yet its mean is that of the corners: it is
    // off by no more than it bends.
    let seen = differing.min(Lanes::splat(bend));
    // What is brighter than white is white on the screen.
    let is_white = least.simd_ge(Lanes::ONE);
    let [r, g, b, _] = is_white.select(Lanes::ZERO, seen * seen).to_array();
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
