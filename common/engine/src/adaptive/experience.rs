//! `Experience`: what cells that were divided have shown of those that were not.
//!
//! - How much the corners of a cell differ, and how far off their mean is: by about
//!   as much as dividing changed it.
//! - How much cells hide that look even.
//! - How far the cells of a pixel err together. Where an edge is level, or upright, it
//!   lies equally high in all cells of a pixel that it crosses: their errors do not
//!   cancel out, and their squares sum up to far less than the square of their sum.

use common::Color;

use super::cell::{Cell, DEEPEST, PIXEL_DEPTH, weight};

const DEPTHS: usize = DEEPEST as usize + 1;

/// Numbers for cells of each depth.
pub type ByDepth = [f64; DEPTHS];

/// Sums over divided cells.
#[derive(Clone, Copy, Debug, Default)]
pub struct Experience {
    seen: Found,
    hidden: Found,
    together: Found,
}

/// What was found, and what that is a share of.
#[derive(Clone, Copy, Debug, Default)]
struct Found {
    found: ByDepth,
    of: ByDepth,
}

/// What is expected of the others.
#[derive(Clone, Copy, Debug)]
pub struct Factors {
    /// The squared error, of what the corners show and of what they could hide.
    pub seen: ByDepth,
    pub hidden: ByDepth,
    /// So much larger are the squared errors of the cells of a pixel together.
    pub together: ByDepth,
}

/// A level edge may lie anywhere in a cell, and the share of the corners on its one
/// side is always a half: the mean square of a number between -1/2 and 1/2 is 1/12.
/// For slanted edges it is less, 0.039 over all straight lines that meet a square.
const EDGE: f64 = 1.0 / 12.0;
/// To divide a cell at a level edge changes it by 1/4, the square of which is 1/16.
const ERROR_OF_CHANGE: f64 = 16.0 * EDGE;
/// Before anything is known, cells hide a tenth of what they could.
const HIDDEN: f64 = EDGE / 10.0;
/// Each division makes squared errors together so much larger, halfway between edges
/// whose errors cancel out and those where they do not.
const STEP: f64 = std::f64::consts::SQRT_2;
/// As if about so many cells, black on one side and white on the other, had shown that.
const CELLS: f64 = 4.0;

impl Experience {
    /// Cells of one pixel were divided, and their light has changed by so much.
    pub fn learn(&mut self, cells: &[(&Cell, Color)]) {
        let square = |color: Color| (color * color).channels().iter().sum::<f64>();
        let (mut sums, mut deepest) = ([Color::BLACK; DEPTHS], 0);
        for &(cell, change) in cells {
            let depth = usize::from(cell.depth);
            if !square(change).is_finite() {
                // Light that is no number teaches nothing.
                continue;
            }
            let error = ERROR_OF_CHANGE * weight(cell.depth) * square(change);
            if cell.looks_even() {
                self.hidden.add(depth, error, cell.hidden.into());
            } else {
                self.seen.add(depth, error, cell.seen.into());
            }
            self.together.add(depth, 0.0, square(change));
            sums[depth] += change;
            deepest = deepest.max(depth);
        }
        for (depth, sum) in sums[..=deepest].iter().enumerate() {
            self.together.add(depth, square(*sum), 0.0);
        }
    }

    /// What all these have shown. What was found at one depth goes on to the next.
    pub fn factors<'a>(all: impl Iterator<Item = &'a Self>) -> Factors {
        let mut sum = Self::default();
        for one in all {
            sum.seen.add_all(&one.seen);
            sum.hidden.add_all(&one.hidden);
            sum.together.add_all(&one.together);
        }
        let mut factors = Factors {
            seen: ByDepth::default(),
            hidden: ByDepth::default(),
            together: [1.0; DEPTHS],
        };
        let (mut seen, mut hidden) = (EDGE, HIDDEN);
        for depth in 0..DEPTHS {
            let cells = CELLS * 3.0 * weight(depth as u8);
            seen = sum.seen.share(depth, seen, cells);
            hidden = sum.hidden.share(depth, hidden, cells);
            factors.seen[depth] = seen;
            factors.hidden[depth] = hidden;
        }
        // A block, and a pixel, is one cell: only their parts can err together.
        let (mut cells_together, mut step) = (1.0, STEP);
        let parts_of_pixels = usize::from(PIXEL_DEPTH) + 1;
        for depth in parts_of_pixels..DEPTHS {
            let expected = cells_together * step;
            let share = sum.together.share(depth, expected, CELLS * 3.0 * EDGE);
            step = (share / cells_together).clamp(1.0, 2.0);
            cells_together *= step;
            factors.together[depth] = cells_together;
        }
        let level = ((factors.together[parts_of_pixels] - STEP) / (2.0 - STEP)).max(0.0);
        factors.together = factors
            .together
            .map(|together| together * (1.0 + 2.0 * level));
        factors
    }
}

impl Found {
    fn add(&mut self, depth: usize, found: f64, of: f64) {
        self.found[depth] += found;
        self.of[depth] += of;
    }

    fn add_all(&mut self, other: &Self) {
        for depth in 0..DEPTHS {
            self.add(depth, other.found[depth], other.of[depth]);
        }
    }

    /// The share that was found of all, where another was expected and has so much
    /// weight.
    fn share(&self, depth: usize, expected: f64, weight: f64) -> f64 {
        let share = (expected * weight + self.found[depth]) / (weight + self.of[depth]);
        // Sums of far too bright light may have no end.
        if share.is_finite() { share } else { expected }
    }
}

#[cfg(test)]
mod tests;
