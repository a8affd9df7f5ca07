//! Tests of `level`.

use common::Color;

use super::*;

/// A cell of this depth that shows and could hide so much.
fn cell(depth: u8, seen: f32, hidden: f32) -> Cell {
    let mut cell = Cell::block(0, 0, [Color::BLACK; 4], 0.0);
    (cell.depth, cell.seen, cell.hidden) = (depth, seen, hidden);
    cell
}

#[test]
fn bins_are_quarters_of_octaves() {
    for power in [f64::MIN_POSITIVE, 0.25, 1.0, 64.0] {
        for (quarter, end) in (0..).zip([1.0, 1.25, 1.5, 1.75]) {
            assert_eq!(bin(power * end), bin(power) + quarter);
            assert_eq!(bin((power * end).next_down()) + 1, bin(power) + quarter);
            assert_eq!(lower_end(bin(power * (end + 0.2))), power * end);
        }
    }
    assert_eq!(lower_end(bin(f64::INFINITY)), f64::INFINITY);
}

/// A pixel, of depth 2, has one sample, and its four parts have four.
#[test]
fn cells_are_divided_until_a_pixel_has_as_many_samples_as_it_may() {
    let deepest = [
        (0, 2),
        (1, 2),
        (3, 2),
        (4, 3),
        (15, 3),
        (16, 4),
        (1024, 7),
        (1 << 16, 10),
        (u32::MAX, 10),
    ];
    for (samples, depth) in deepest {
        let mut level = Level::unknown(samples, 1.0);
        assert!(!level.is_due(&cell(0, 1e9, 1e9)), "nothing is known");
        level.divided = 0.0;
        assert!(level.is_due(&cell(depth - 1, 1.0, 1.0)), "{samples}");
        assert!(!level.is_due(&cell(depth, 1.0, 1.0)), "{samples}");
    }
}

/// At a depth of 4, cells err together by the square of the root of two.
#[test]
fn errors_are_a_twelfth_of_what_is_seen_and_a_tenth_of_that_of_what_is_hidden() {
    let level = Level::unknown(1024, 1.0);
    let near = |error: f64, expected: f64| (error - expected).abs() < 1e-14 * expected;
    assert!(near(level.error(&cell(0, 12.0, 120.0)), 2.0));
    assert!(near(level.error(&cell(1, 12.0, 0.0)), 1.0));
    assert!(near(level.error(&cell(4, 24.0, 120.0)), 6.0));
    let (mut seen, mut hidden) = (ByDepth::default(), ByDepth::default());
    (seen[0], hidden[1], seen[4], hidden[4]) = (12.0, 240.0, 24.0, 120.0);
    assert!(near(level.sum(&seen, &hidden), 1.0 + 2.0 + 6.0));
}

/// A fifth of the error that a pixel may have, and an eighth of that for its parts,
/// which are expected to err together by the root of two.
#[test]
fn cells_that_err_by_little_are_not_kept() {
    let level = Level::unknown(1024, 3.0);
    assert!(level.keeps(&cell(0, 7.21, 0.0)));
    assert!(!level.keeps(&cell(0, 7.19, 0.0)));
    assert!(level.keeps(&cell(2, 0.0, 72.1)));
    assert!(!level.keeps(&cell(2, 0.0, 71.9)));
    let root = std::f32::consts::SQRT_2;
    assert!(level.keeps(&cell(3, 0.91 / root, 0.0)));
    assert!(!level.keeps(&cell(3, 0.89 / root, 0.0)));
}

/// What is left if all that err by this are divided, as long as they may: an edge
/// crosses two parts, of which each has a quarter of the pixels, or of the area,
/// whose square is a sixteenth.
fn left(level: &Level, cells: &[Cell], divided: f64) -> f64 {
    let come_down = |cell: &Cell| {
        let (mut depth, mut error, mut parts) = (cell.depth, level.error(cell), 1.0);
        while depth < 7 && error >= divided {
            let part = if depth < 2 { 4.0 } else { 16.0 };
            (depth, error, parts) = (depth + 1, error / part, 2.0 * parts);
        }
        parts * error
    };
    cells.iter().map(come_down).sum()
}

/// The level is low enough, and the next one above is not.
#[test]
fn the_level_brings_errors_down_to_what_is_allowed_and_little_farther() {
    let cell = |i: u16| cell((1 + i % 4) as u8, f32::from(i * i) / 40_000.0, 0.1);
    let cells: Vec<_> = (0..200).map(cell).collect();
    for share in [0.9, 0.5, 0.1, 0.02] {
        let mut level = Level::unknown(1024, 1e-9);
        let sum = cells.iter().map(|cell| level.error(cell)).sum();
        let allowed = share * sum;
        level.come_down(cells.iter(), sum, allowed);
        let divided = level.divided;
        assert!(left(&level, &cells, divided) <= allowed * (1.0 + 1e-9));
        let above = lower_end(bin(divided) + 1);
        assert!(left(&level, &cells, above) > allowed * (1.0 - 1e-9));
        assert_eq!(level.kept, divided / 32.0);
        for cell in &cells {
            assert_eq!(level.is_due(cell), level.error(cell) >= divided);
            assert_eq!(
                level.keeps(cell),
                level.error(cell) >= divided / if cell.depth > 2 { 32.0 } else { 4.0 }
            );
        }
    }
}

/// The pixel errs by 1.1, and 1/2 is elsewhere. Divided once it leaves 1.1/8 and
/// twice 1.1/64; its parts err by 1.1/16.
#[test]
fn what_cannot_be_divided_counts() {
    let divided = |allowed: f64| {
        let mut level = Level::unknown(1024, 0.0);
        level.come_down([cell(2, 13.2, 0.0)].iter(), 1.6, allowed);
        level.divided
    };
    assert_eq!(divided(1.59), 1.0);
    let pixel = cell(2, 13.2, 0.0);
    let once = 1.6 - 0.875 * Level::unknown(1024, 0.0).error(&pixel);
    assert_eq!(divided(once), 1.0);
    assert_eq!(divided(0.64), 1.0);
    assert_eq!(divided(0.63), 1.0 / 16.0);
    assert_eq!(divided(0.52), 1.0 / 16.0);
    assert_eq!(divided(0.51), 1.0 / 256.0);
    assert_eq!(divided(0.49), 0.0);
}

/// It errs by 1.1, its parts by 1.1/4 and pixels by 1.1/16, and an edge crosses twice
/// as many each time.
#[test]
fn dividing_blocks_takes_half_off() {
    let divided = |allowed: f64| {
        let mut level = Level::unknown(1024, 0.0);
        level.come_down([cell(0, 13.2, 0.0)].iter(), 1.1, allowed);
        level.divided
    };
    assert_eq!(divided(1.0), 1.0);
    assert_eq!(divided(0.56), 1.0);
    assert_eq!(divided(0.54), 0.25);
    assert_eq!(divided(0.276), 0.25);
    assert_eq!(divided(0.274), 0.0625);
    // A pixel has an eighth: 4 x 1.1/128.
    assert_eq!(divided(0.035), 0.0625);
    assert_eq!(divided(0.034), 0.0625 / 16.0);
}

#[test]
fn cells_that_cannot_be_divided_take_nothing_off() {
    let mut level = Level::unknown(4, 0.0);
    let cells = [cell(3, 13.2, 0.0), cell(2, 6.5, 0.0)];
    level.come_down(cells.iter(), 2.1, 2.0);
    assert_eq!(level.divided, 0.5);
}

#[test]
fn the_level_comes_down_to_what_was_kept_at_most() {
    let mut level = Level::unknown(1024, 40.0);
    level.come_down([cell(0, 13.2, 0.0)].iter(), 1.1, 0.001);
    assert_eq!((level.divided, level.kept), (1.0, 1.0 / 32.0));
    assert!(level.is_due(&cell(0, 12.1, 0.0)));
    assert!(!level.is_due(&cell(0, 11.9, 0.0)));
}

/// As in the tests of experience: 2/15 of what is seen.
#[test]
fn a_level_heeds_experience() {
    let mut experience = Experience::default();
    experience.learn(&[(&cell(1, 12.0, 12.0), Color::gray(0.5))]);
    let mut level = Level::unknown(1024, 1.0);
    level.learn([experience].iter());
    assert!((level.error(&cell(1, 15.0, 0.0)) - 2.0).abs() < 1e-14);
}
