//! Tests of `cell`.

use super::*;

fn grays<const N: usize>(grays: [f64; N]) -> [Color; N] {
    grays.map(Color::gray)
}

/// What a block shows and could hide.
fn squares_of(corners: [Color; 4], bend: f32) -> (f32, f32) {
    let block = Cell::block(0, 0, corners, bend);
    (block.seen, block.hidden)
}

#[test]
fn crosses_lie_in_the_middles_of_cells_and_of_their_sides() {
    let block = Cell::block(3, 5, grays([0.0; 4]), 0.0);
    let [top, left, middle, right, below] = [
        (1280, 1280),
        (768, 1792),
        (1280, 1792),
        (1792, 1792),
        (1280, 2304),
    ];
    assert_eq!(block.places(), [top, left, middle, right, below]);
    let [_, part, ..] = block.divided(&grays([0.0; 5]));
    let [top, left, middle, right, below] = [
        (1536, 1280),
        (1280, 1536),
        (1536, 1536),
        (1792, 1536),
        (1536, 1792),
    ];
    assert_eq!(part.places(), [top, left, middle, right, below]);
}

#[test]
fn parts_have_the_light_of_their_own_corners() {
    let block = Cell::block(3, 5, grays([1.0, 3.0, 7.0, 9.0]), 0.0);
    let parts = block.divided(&grays([2.0, 4.0, 5.0, 6.0, 8.0]));
    let corners = [
        [1.0, 2.0, 4.0, 5.0],
        [2.0, 3.0, 5.0, 6.0],
        [4.0, 5.0, 7.0, 8.0],
        [5.0, 6.0, 8.0, 9.0],
    ];
    assert_eq!(parts.map(|part| part.corners), corners.map(grays));
    let pixels = [(3, 5), (5, 5), (3, 7), (5, 7)];
    assert_eq!(parts.map(|part| part.pixel()), pixels);
    assert_eq!(parts.map(|part| part.light()), grays([3.0, 4.0, 6.0, 7.0]));
}

/// Always the lower right one: 512 + 256 + ... + 1 from the corner of the block.
#[test]
fn parts_are_quarters_down_to_the_deepest() {
    let mut cell = Cell::block(0, 0, grays([0.0; 4]), 0.0);
    let (mut area, mut left) = (16.0, 1024);
    for depth in 0..10 {
        assert_eq!((cell.depth, cell.area()), (depth, area));
        assert_eq!((cell.x, cell.y), (1024 - left, 1024 - left));
        let parts = cell.divided(&grays([0.0; 5]));
        assert_eq!(parts.iter().map(Cell::area).sum::<f64>(), area);
        cell = parts[3];
        (area, left) = (area / 4.0, left / 2);
    }
    assert_eq!((cell.depth, cell.x, cell.y), (DEEPEST, 1023, 1023));
}

#[test]
fn a_block_counts_for_its_pixels_and_parts_of_these_for_their_area_squared() {
    let expected = [16.0, 4.0, 1.0, 1.0 / 16.0, 1.0 / 256.0];
    assert_eq!([0, 1, 2, 3, 4].map(weight), expected);
    assert_eq!(weight(DEEPEST), 1.0 / 4_294_967_296.0);
}

#[test]
fn a_cell_shows_by_how_much_its_corners_differ_and_hides_what_bends() {
    let corners = [
        Color::new(0.75, 0.25, 0.5),
        Color::new(0.25, 0.25, 0.5),
        Color::new(0.5, 0.0, 0.5),
        Color::new(0.5, 0.25, 0.75),
    ];
    let halves = 16.0 * 0.5;
    let seen = halves * (0.25 + 0.0625 + 0.0625);
    assert_eq!(squares_of(corners, 1.0), (seen, 48.0));
    let limited = 3.0 * 0.0625;
    let expected = (halves * limited, 16.0 * limited);
    assert_eq!(squares_of(corners, 0.25), expected);
    assert_eq!(squares_of(corners, 0.0), (0.0, 0.0));
}

/// Whichever these are.
#[test]
fn two_corners_on_each_side_show_twice_what_one_alone_does() {
    for i in 0..4 {
        let mut one = [0.25; 4];
        one[i] = 0.75;
        assert_eq!(squares_of(grays(one), 1.0), (12.0 * 0.5, 48.0));
        for other in (0..4).filter(|other| *other != i) {
            let mut two = one;
            two[other] = 0.75;
            assert_eq!(squares_of(grays(two), 1.0), (12.0, 48.0));
        }
    }
    // The two in the middle are half as far from each other as the others.
    let seen = 48.0 * (1.0 + 0.25) / 2.0;
    assert_eq!(squares_of(grays([0.0, 0.25, 1.0, 0.75]), 1.0), (seen, 48.0));
}

#[test]
fn channels_that_are_white_at_all_corners_count_nothing() {
    let red_white = [1.0, 2.0, 3.0, 1.0].map(|red| Color::new(red, 0.0, 0.0));
    assert_eq!(squares_of(red_white, 1.0), (0.0, 32.0));
    let blue_white = [0.0, 0.0, 0.5, 0.0].map(|green| Color::new(0.0, green, 1.0));
    assert_eq!(squares_of(blue_white, 1.0), (2.0, 32.0));
    assert_eq!(squares_of(grays([1.0, 9.0, 1.0, 1.0]), 8.0), (0.0, 0.0));
    assert_eq!(squares_of(grays([0.5, 1.5, 1.0, 1.0]), 8.0), (24.0, 3072.0));
}

#[test]
fn light_that_is_no_number_or_has_no_end_counts_nothing() {
    assert_eq!(squares_of(grays([f64::NAN; 4]), f32::NAN), (0.0, 0.0));
    let infinite = grays([0.0, f64::INFINITY, 0.0, 0.0]);
    assert_eq!(squares_of(infinite, f32::INFINITY), (0.0, 0.0));
    let [part, ..] = Cell::block(0, 0, infinite, 1.0).divided(&grays([f64::INFINITY; 5]));
    assert_eq!((part.seen, part.hidden), (0.0, 0.0));
}

#[test]
fn light_that_changes_evenly_does_not_bend() {
    let ramp = [0.0, 1.0, 2.0, 3.0];
    let middles = [0.5, 1.0, 1.5, 2.0, 2.5];
    let bend_of = |middles: [Color; 5]| bend(grays(ramp).map(lanes), middles.map(lanes));
    assert_eq!(bend_of(grays(middles)), 0.0);
    // What is off by 1/4 bends by twice that.
    for i in 0..5 {
        for color in [Color::RED, Color::GREEN, Color::BLUE] {
            for off in [0.25, -0.25] {
                let mut middles = grays(middles);
                middles[i] += color * off;
                assert_eq!(bend_of(middles), 0.5, "{i}");
            }
        }
    }
}

/// An upright edge just right of the left side.
#[test]
fn light_bends_at_an_edge_by_its_height() {
    let corners = grays([0.0, 0.75, 0.0, 0.75]).map(lanes);
    let cross = grays([0.75, 0.0, 0.75, 0.75, 0.75]).map(lanes);
    assert_eq!(bend(corners, cross), 0.75);
}

#[test]
fn half_of_what_bends_around_a_cell_bends_around_its_parts() {
    let even = grays([0.5; 5]);
    let block = Cell::block(0, 0, grays([0.5; 4]), 1.0);
    let [part, ..] = block.divided(&even);
    assert_eq!((part.seen, part.hidden), (0.0, 12.0 * 0.25));
    let [part, ..] = part.divided(&even);
    assert_eq!(part.hidden, 3.0 * 0.0625);
    // Its own middle bends by 3/4, which is more.
    let [part, ..] = block.divided(&grays([0.5, 0.5, 0.875, 0.5, 0.5]));
    assert_eq!((part.seen, part.hidden), (6.0 * 0.140_625, 12.0 * 0.5625));
}

#[test]
fn corners_look_even_that_differ_by_less_than_a_tenth_of_what_bends() {
    let looks_even = |gray: f64| Cell::block(0, 0, grays([0.0, gray, 0.0, gray]), 1.0);
    assert!(looks_even(0.0).looks_even());
    assert!(looks_even(0.099).looks_even());
    assert!(!looks_even(0.101).looks_even());
    let flat = Cell::block(0, 0, grays([0.5; 4]), 0.0);
    assert!(!flat.looks_even(), "nothing is around");
}

#[test]
fn the_mean_of_equal_colors_is_that_color() {
    assert_eq!(mean(grays([0.3; 4])), Color::gray(0.3));
    assert_eq!(mean(grays([0.0, 1.0, 2.0, 4.0])), Color::gray(1.75));
}

fn light_of(corners: [f64; 4]) -> f64 {
    Cell::block(0, 0, grays(corners), 0.0).light().g
}

#[test]
fn light_that_changes_evenly_is_that_in_the_middle_of_the_cell() {
    assert_eq!(light_of([0.3; 4]), 0.3);
    assert_eq!(light_of([1.0, 2.0, 4.0, 5.0]), 3.0);
    assert_eq!(light_of([5.0, 2.0, 4.0, 1.0]), 3.0);
    assert_eq!(light_of([0.0, 0.0, 1.0, 1.0]), 0.5);
    assert_eq!(light_of([1.0, 0.0, 0.0, 1.0]), 0.5);
}

#[test]
fn a_corner_that_is_cut_off_has_the_share_that_lines_cut_off() {
    let root = std::f64::consts::SQRT_2;
    // ln(1 + r), the inverse hyperbolic sine of 1.
    let log = 0.881_373_587_019_543;
    let share = (log - 1.0 / root) / (3.0 * (2.0 - root));
    for corner in 0..4 {
        let mut corners = [0.0; 4];
        corners[corner] = 1.0;
        assert!((light_of(corners) - share).abs() < 1e-4);
        assert!((light_of(corners.map(|gray| 1.0 - gray)) - (1.0 - share)).abs() < 1e-4);
    }
}

/// The sum of colours, so that no channel is taken for another.
#[test]
fn channels_do_not_share_their_corners() {
    let corners = [
        Color::RED,
        Color::BLUE,
        Color::GREEN,
        Color::RED + Color::BLUE,
    ];
    let light = Cell::block(0, 0, corners, 1.0).light();
    assert_eq!((light.r, light.b), (0.5, 0.5));
    assert!((light.g - 0.0991).abs() < 1e-9);
}

#[test]
fn light_without_end_stays_that() {
    assert_eq!(light_of([f64::INFINITY; 4]), f64::INFINITY);
    assert_eq!(light_of([0.0, f64::INFINITY, 0.0, 1.0]), f64::INFINITY);
    assert!(light_of([f64::NAN, 0.0, 0.0, 0.0]).is_nan());
}
