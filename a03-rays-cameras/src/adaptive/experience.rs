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
mod tests {
    use std::f64::consts::SQRT_2;

    use super::*;

    /// A cell of this depth that shows and could hide so much, as a block would.
    fn cell(depth: u8, seen: f64, hidden: f64) -> Cell {
        let mut cell = Cell::block(0, 0, [Color::BLACK; 4], 0.0);
        cell.depth = depth;
        cell.seen = (weight(depth) * seen) as f32;
        cell.hidden = (weight(depth) * hidden) as f32;
        cell
    }

    /// What pixels, with such changes of cells, have shown.
    fn factors(pixels: &[&[(&Cell, Color)]]) -> Factors {
        let mut experience = Experience::default();
        for pixel in pixels {
            experience.learn(pixel);
        }
        Experience::factors([experience].iter())
    }

    fn assert_near(found: ByDepth, expected: [f64; 11]) {
        for (depth, (found, expected)) in found.iter().zip(expected).enumerate() {
            let off = (found - expected).abs();
            assert!(off < 1e-14 * expected, "depth {depth}: {found}, {expected}");
        }
    }

    /// 1 up to pixels, and then each so many times the one before.
    fn growing(step: f64) -> [f64; 11] {
        std::array::from_fn(|depth| (2..depth).fold(1.0, |grown, _| grown * step))
    }

    #[test]
    fn without_cells_edges_are_expected_to_be_level_and_half_together() {
        let factors = Experience::factors([].iter());
        assert_near(factors.seen, [1.0 / 12.0; 11]);
        assert_near(factors.hidden, [1.0 / 120.0; 11]);
        assert_near(factors.together, growing(SQRT_2));
    }

    #[test]
    fn a_level_edge_shows_what_was_expected() {
        for depth in 0..11 {
            let edge = cell(depth, 3.0, 3.0);
            let factors = factors(&[&[(&edge, Color::gray(0.25))]]);
            assert_near(factors.seen, [1.0 / 12.0; 11]);
        }
    }

    /// Black and white that change by 1/2: the error is 4/3 (1/2)^2 for each channel,
    /// 1/3 of what is seen. Four cells of 1/12 come first: (4/12 + 1/3) / (4 + 1).
    #[test]
    fn what_a_cell_shows_goes_on_to_deeper_ones() {
        for depth in 0..11 {
            let at = usize::from(depth);
            let change = Color::gray(0.5);
            let mut expected = [1.0 / 12.0; 11];
            expected[at..].fill(2.0 / 15.0);
            let seen = factors(&[&[(&cell(depth, 3.0, 3.0), change)]]);
            assert_near(seen.seen, expected);
            assert_near(seen.hidden, [1.0 / 120.0; 11]);

            // (4/120 + 1/3) / (4 + 1).
            let mut expected = [1.0 / 120.0; 11];
            expected[at..].fill(11.0 / 150.0);
            let hidden = factors(&[&[(&cell(depth, 0.0, 3.0), change)]]);
            assert_near(hidden.hidden, expected);
            assert_near(hidden.seen, [1.0 / 12.0; 11]);
        }
    }

    /// Two cells: (4/12 + 2/3) / (4 + 2), and none that looks even.
    #[test]
    fn what_all_have_shown_is_summed() {
        let (edge, change) = (cell(0, 3.0, 3.0), Color::gray(0.5));
        let mut one = Experience::default();
        one.learn(&[(&edge, change)]);
        let both = Experience::factors([one, one].iter());
        assert_near(both.seen, [1.0 / 6.0; 11]);
        let hidden = cell(0, 0.0, 3.0);
        let mut other = Experience::default();
        other.learn(&[(&hidden, change)]);
        let both = Experience::factors([one, other].iter());
        assert_near(both.seen, [2.0 / 15.0; 11]);
        assert_near(both.hidden, [11.0 / 150.0; 11]);
    }

    /// Both change by 1 in three channels: the square of the sum is 12, the sum of the
    /// squares 6, and what is expected counts as 1. Then
    /// s = (12 + r) / 7 with the root r of two, and (s - r) / (2 - r) = 6/7.
    #[test]
    fn cells_of_a_pixel_that_change_alike_err_together() {
        let edge = cell(3, 3.0, 3.0);
        let alike = factors(&[&[(&edge, Color::WHITE), (&edge, Color::WHITE)]]);
        let step = (12.0 + SQRT_2) / 7.0;
        let expected = growing(step).map(|together| together * (1.0 + 2.0 * 6.0 / 7.0));
        assert_near(alike.together, expected);
    }

    /// Four that change alike go beyond what an edge does: (48 + r) / 13 > 2.
    #[test]
    fn errors_double_with_each_division_at_most_and_level_edges_triple_them() {
        let edge = cell(3, 3.0, 3.0);
        let alike = factors(&[&[(&edge, Color::gray(-1.0)); 4]]);
        assert_near(alike.together, growing(2.0).map(|together| 3.0 * together));
    }

    #[test]
    fn errors_that_cancel_out_are_no_larger_together() {
        let change = [Color::WHITE, Color::gray(-1.0)];
        let edge = cell(3, 3.0, 3.0);
        let cancelling = factors(&[&change.map(|change| (&edge, change))]);
        assert_near(cancelling.together, [1.0; 11]);
        let edge = cell(4, 3.0, 3.0);
        let cancelling = factors(&[&change.map(|change| (&edge, change))]);
        let mut expected = [SQRT_2; 11];
        expected[..3].fill(1.0);
        assert_near(cancelling.together, expected);
    }

    /// Red and blue do not cancel out, nor do cells of two depths or of two pixels.
    /// One that changes by 1 makes s = (3 + r) / 4, and two alike at the next depth,
    /// where s^2 is expected, (12 + s^2) / 7.
    #[test]
    fn only_what_one_pixel_shows_at_one_depth_is_together() {
        let (large, small) = (cell(3, 3.0, 3.0), cell(4, 3.0, 3.0));
        let large_white = (&large, Color::WHITE);
        let black = (&small, Color::gray(-1.0));
        let first = (3.0 + SQRT_2) / 4.0;
        let next = (12.0 + first * first) / 7.0 / first;
        let mut expected = growing(next).map(|together| together * first / next);
        expected[..3].fill(1.0);
        for pixels in [
            &[&[large_white, black, black][..]][..],
            &[&[black, black, large_white]],
            &[&[large_white], &[black, black]],
        ] {
            assert_near(factors(pixels).together, expected);
        }
        let opposite = (&large, Color::gray(-1.0));
        let step = (6.0 + SQRT_2) / 7.0;
        let two_pixels = factors(&[&[large_white], &[opposite]]);
        assert_near(two_pixels.together, growing(step));
        let red_and_blue = [Color::RED, Color::BLUE * -1.0].map(|change| (&large, change));
        let step = (2.0 + SQRT_2) / 3.0;
        assert_near(factors(&[&red_and_blue]).together, growing(step));
    }

    #[test]
    fn light_that_is_no_number_shows_nothing() {
        for change in [f64::NAN, f64::INFINITY] {
            let (edge, hidden) = (cell(3, 3.0, 3.0), cell(3, 0.0, 3.0));
            let change = Color::gray(change);
            let factors = factors(&[&[(&edge, change), (&hidden, change)]]);
            assert_near(factors.seen, [1.0 / 12.0; 11]);
            assert_near(factors.hidden, [1.0 / 120.0; 11]);
            assert_near(factors.together, growing(SQRT_2));
        }
    }
}
