//! `Level`: which cells are divided, because they err more than that.

use super::cell::{Cell, DEEPEST, PIXEL_DEPTH, weight};
use super::experience::{ByDepth, Experience, Factors};

/// The error from which on cells are divided, and what that rests on.
pub struct Level {
    factors: Factors,
    divided: f64,
    /// Parts of pixels that err less than this are never divided.
    kept: f64,
    deepest: u8,
}

/// The level comes down as more is known, but never so far.
const FARTHEST: f64 = 1.0 / 32.0;

/// Nor so far for cells of this depth: it is parts of pixels that may turn out to err
/// together, many times as much as was expected.
const fn farthest(depth: u8) -> f64 {
    if depth > PIXEL_DEPTH {
        FARTHEST
    } else {
        1.0 / 4.0
    }
}

impl Level {
    /// The level for so many samples a pixel, at most, before anything is known;
    /// `fair` is the error that every pixel may have.
    pub fn unknown(samples: u32, fair: f64) -> Self {
        let divisions_of_pixels = samples.max(1).ilog2() / 2;
        Self {
            factors: Experience::factors(std::iter::empty()),
            divided: f64::INFINITY,
            // Pixels are kept that err by a fifth of that.
            kept: fair / 5.0 * FARTHEST / farthest(PIXEL_DEPTH),
            deepest: DEEPEST.min(PIXEL_DEPTH + divisions_of_pixels as u8),
        }
    }

    /// Brings the level down so far that the errors of all cells, which sum up to
    /// `sum` now, are expected to be what is `allowed`. These cells may be divided.
    ///
    /// Whoever errs most is divided first: each division that a cell may go through
    /// is put into the bin of its error, with what it takes off the sum, and the bins
    /// are emptied from the top.
    pub fn come_down<'a>(
        &mut self,
        cells: impl Iterator<Item = &'a Cell>,
        mut sum: f64,
        allowed: f64,
    ) {
        let mut bins = vec![0.0; bin(f64::INFINITY)];
        for cell in cells {
            let (mut error, mut parts) = (self.error(cell), 1.0);
            for depth in cell.depth..self.deepest {
                if error < self.kept {
                    break;
                }
                let part = error * weight(depth + 1) / weight(depth);
                bins[bin(error)] += parts * (error - PARTS_CUT * part);
                (error, parts) = (part, parts * PARTS_CUT);
            }
        }
        let mut level = bins.len();
        while sum > allowed && level > 0 {
            level -= 1;
            sum -= bins[level];
        }
        self.divided = lower_end(level).max(self.kept);
        self.kept = self.divided * FARTHEST;
    }

    /// Heeds what divided cells have shown.
    pub fn learn<'a>(&mut self, experience: impl Iterator<Item = &'a Experience>) {
        self.factors = Experience::factors(experience);
    }

    /// The estimated squared error that a cell adds to the picture, summed over the
    /// channels.
    #[inline]
    pub fn error(&self, cell: &Cell) -> f64 {
        self.error_of(cell.depth.into(), cell.seen.into(), cell.hidden.into())
    }

    /// That of cells that show such errors and could hide such, by their depth.
    pub fn sum(&self, seen: &ByDepth, hidden: &ByDepth) -> f64 {
        let both = seen.iter().zip(hidden).enumerate();
        both.map(|(depth, (seen, hidden))| self.error_of(depth, *seen, *hidden))
            .sum()
    }

    #[inline]
    fn error_of(&self, depth: usize, seen: f64, hidden: f64) -> f64 {
        let Factors {
            seen: of_seen,
            hidden: of_hidden,
            together,
        } = &self.factors;
        together[depth] * (of_seen[depth] * seen + of_hidden[depth] * hidden)
    }

    /// Whether the cell is to be divided.
    pub fn is_due(&self, cell: &Cell) -> bool {
        cell.depth < self.deepest && self.error(cell) >= self.divided
    }

    /// Whether it ever may be.
    pub fn keeps(&self, cell: &Cell) -> bool {
        self.error(cell) >= self.kept * farthest(cell.depth) / FARTHEST
    }
}

/// So many of its four parts an edge crosses that crosses a cell.
const PARTS_CUT: f64 = 2.0;

/// Bins of positive numbers: each power of two has four, by the first two bits
/// behind the point.
const fn bin(number: f64) -> usize {
    (number.to_bits() >> 50) as usize
}

const fn lower_end(bin: usize) -> f64 {
    f64::from_bits((bin as u64) << 50)
}

#[cfg(test)]
mod tests;
