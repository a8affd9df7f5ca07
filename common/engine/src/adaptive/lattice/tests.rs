//! Tests of `lattice`.

use super::super::drawn::Drawn;
use super::super::place::Place;
use super::*;

/// The side of a block, in units of the smallest cells.
const SIDE: u32 = 1024;

/// Changes evenly across, down, and differently in each channel.
fn ramp((x, y): Place) -> Color {
    Color::new(x.into(), y.into(), (3 * x + y).into())
}

fn lattice(width: u32, height: u32, first_row: u32, light: fn(Place) -> Color) -> Lattice {
    Lattice::new(
        Size::new(width, height).unwrap(),
        first_row,
        &Drawn::new(light),
    )
    .unwrap()
}

fn blocks(lattice: &Lattice, rows: Range<u32>) -> Vec<Cell> {
    let mut blocks = Vec::new();
    lattice.for_each_cell(&rows, |block| blocks.push(block));
    blocks
}

#[test]
fn corners_of_blocks_are_looked_at_once_and_few_together() {
    for (width, height, columns, rows) in
        [(9, 6, 4, 3), (8, 8, 3, 3), (1, 1, 2, 2), (397, 2, 101, 2)]
    {
        let view = Drawn::new(ramp);
        let lattice = Lattice::new(Size::new(width, height).unwrap(), 7, &view).unwrap();
        let corners =
            (0..columns).flat_map(|x| (0..rows).map(move |y| (SIDE * x, 7 * 256 + SIDE * y)));
        let (asked, together) = view.asked();
        assert_eq!(asked, corners.collect::<Vec<_>>());
        assert_eq!(lattice.samples(), asked.len() as u64);
        assert_eq!(lattice.cells_in_a_row(), columns as usize - 1);
        assert!(together <= BATCH);
    }
}

#[test]
fn nothing_is_looked_at_once_the_picture_is_not_wanted() {
    let mut view = Drawn::new(ramp);
    view.stopped = true;
    Lattice::new(Size::COURSE, 0, &view).unwrap();
    assert_eq!(view.asked(), (vec![], 0));
}

#[test]
fn blocks_come_column_by_column_with_the_light_at_their_corners() {
    let lattice = lattice(9, 9, 7, ramp);
    let pixels = |rows| {
        blocks(&lattice, rows)
            .iter()
            .map(Cell::pixel)
            .collect::<Vec<_>>()
    };
    assert_eq!(
        pixels(7..15),
        [(0, 7), (0, 11), (4, 7), (4, 11), (8, 7), (8, 11)]
    );
    assert_eq!(
        pixels(11..16),
        [(0, 11), (0, 15), (4, 11), (4, 15), (8, 11), (8, 15)]
    );
    assert_eq!(pixels(15..16), [(0, 15), (4, 15), (8, 15)]);
    for Cell {
        corners,
        x,
        y,
        depth,
        ..
    } in blocks(&lattice, 7..16)
    {
        let places = [(x, y), (x + SIDE, y), (x, y + SIDE), (x + SIDE, y + SIDE)];
        assert_eq!((corners, depth), (places.map(ramp), 0));
    }
}

/// Of 7 x 5 pixels, from the second row and the fifth column of blocks on.
#[test]
fn parts_of_a_picture_have_the_corners_of_smaller_cells() {
    let blocks = lattice(23, 9, 35, ramp);
    for (depth, side, columns, rows) in [(1, 2, 5, 4), (2, 1, 8, 6)] {
        let view = Drawn::new(ramp);
        let part = blocks.part(&(16..23), &(39..44), depth, &view);
        let place = |x: u32, y: u32| (256 * (16 + side * x), 256 * (39 + side * y));
        let all = (0..columns).flat_map(|x| (0..rows).map(move |y| (x, y)));
        let unknown = all.filter(|(x, y)| side * x % 4 != 0 || side * y % 4 != 0);
        let unknown: Vec<_> = unknown.map(|(x, y)| place(x, y)).collect();
        assert_eq!(part.samples(), unknown.len() as u64);
        assert_eq!(view.asked().0, unknown);
        assert_eq!(part.cells_in_a_row(), columns as usize - 1);

        let mut cells = (0..columns - 1).flat_map(|x| (0..rows - 1).map(move |y| (x, y)));
        part.for_each_cell(&(39..44), |cell| {
            let (x, y) = cells.next().unwrap();
            assert_eq!(cell.pixel(), (16 + side * x, 39 + side * y));
            let ends = [(x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1)];
            assert_eq!(cell.corners, ends.map(|(x, y)| ramp(place(x, y))));
            assert_eq!(cell.depth, depth);
        });
        assert_eq!(cells.next(), None);
    }
}

#[test]
fn sides_of_blocks_show_what_lies_evenly_between_their_corners() {
    let lattice = lattice(9, 9, 7, ramp);
    for row in 7..16 {
        let sides: Vec<_> = lattice.sides(row).collect();
        let y = 256 * row + 128;
        let side = |x: u32| ramp((SIDE * x, y));
        let expected = [0, 1, 2].map(|x| [side(x), side(x + 1)]);
        assert_eq!(sides, expected);
    }
}

#[test]
fn pixels_have_their_middles_at_odd_eighths_of_a_block() {
    let middles =
        |a: f64, b: f64| [0, 1, 2, 3].map(|pixel| middle(Color::gray(a), Color::gray(b), pixel).r);
    assert_eq!(middles(0.0, 8.0), [1.0, 3.0, 5.0, 7.0]);
    assert_eq!(middles(16.0, 8.0), [15.0, 13.0, 11.0, 9.0]);
    assert_eq!(middles(0.3, 0.3), [0.3; 4]);
    assert_eq!(middles(f64::INFINITY, f64::INFINITY), [f64::INFINITY; 4]);
}

#[test]
fn light_that_changes_evenly_does_not_bend() {
    let lattice = lattice(24, 16, 0, ramp);
    for y in 0..5 {
        assert_eq!(lattice.bends(y), [0.0; 7]);
    }
    for block in blocks(&lattice, 0..16) {
        assert_eq!((block.seen, block.hidden), (0.0, 0.0));
    }
}

/// In the middle of 7 x 5 corners.
fn white_corner(place: Place) -> Color {
    if place == (3 * SIDE, 2 * SIDE) {
        Color::WHITE
    } else {
        Color::BLACK
    }
}

#[test]
fn light_bends_twice_as_far_at_a_white_corner_as_beside_it() {
    let lattice = lattice(24, 16, 0, white_corner);
    // Those above and below are at the ends, and twice their neighbours inside.
    let end = [0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0];
    let beside = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
    let across = [0.0, 0.0, 1.0, 2.0, 1.0, 0.0, 0.0];
    let expected = [end, beside, across, beside, end];
    assert_eq!([0, 1, 2, 3, 4].map(|y| lattice.bends(y)), expected);
}

/// The square of the bend, in three channels of 16 pixels.
#[test]
fn a_block_could_hide_what_bends_at_any_of_its_corners() {
    let lattice = lattice(24, 16, 0, white_corner);
    let hidden: Vec<_> = (blocks(&lattice, 0..16).iter())
        .map(|block| block.hidden)
        .collect();
    let (none, far) = ([0.0; 4], [0.0, 48.0, 48.0, 0.0]);
    let near = [192.0; 4];
    assert_eq!(hidden, [none, far, near, near, far, none].concat());
}

/// Green, which is between the others.
#[test]
fn two_corners_in_a_row_bend_by_twice_what_they_differ() {
    let lattice = lattice(2, 1, 0, |(x, y)| {
        Color::GREEN * f64::from(x / SIDE + 2 * (y / SIDE))
    });
    assert_eq!([0, 1].map(|y| lattice.bends(y)), [[4.0; 2]; 2]);
}

#[test]
fn places_at_the_ends_have_the_neighbours_of_the_next_inside() {
    assert_eq!([0, 1].map(|i| around(i, 2)), [[0, 0, 1]; 2]);
    assert_eq!([0, 1, 2].map(|i| around(i, 3)), [[0, 1, 2]; 3]);
    let of_five = [[0, 1, 2], [0, 1, 2], [1, 2, 3], [2, 3, 4], [2, 3, 4]];
    assert_eq!([0, 1, 2, 3, 4].map(|i| around(i, 5)), of_five);
}
