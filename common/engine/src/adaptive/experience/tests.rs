//! Tests of `experience`.

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
