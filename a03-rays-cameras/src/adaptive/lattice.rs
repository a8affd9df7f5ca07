//! `Lattice`: the light at the corners of all blocks of 2 x 2 pixels, by which they
//! are judged first.

use std::ops::Range;

use common::{Color, Error, Size};
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;

use super::View;
use super::cell::{Cell, PIXEL, greatest_channel, lanes};
use crate::render::TOGETHER;

/// Colours row after row, two pixels apart. The last ones may lie beside the picture,
/// where its sides are odd.
pub struct Lattice {
    first_row: u32,
    columns: usize,
    colors: Vec<Color>,
}

impl Lattice {
    /// Looks at all corners of a picture of this size, or of rows from `first_row`.
    pub fn new(size: Size, first_row: u32, view: &impl View) -> Result<Self, Error> {
        let [columns, rows] = [size.width(), size.height()].map(|side| side.div_ceil(2) + 1);
        let (columns, rows) = (columns as usize, rows as usize);
        let mut colors = Vec::new();
        let memory = colors.try_reserve_exact(columns * rows);
        memory.map_err(|_| Error::Memory { size })?;
        colors.resize(columns * rows, Color::BLACK);
        let look = |(row, colors): (usize, &mut [Color])| {
            let y = PIXEL * (first_row + 2 * row as u32);
            let mut all = (0_u32..).map(|column| (2 * PIXEL * column, y));
            let (mut places, mut seen) = (Vec::new(), Vec::new());
            for colors in colors.chunks_mut(TOGETHER) {
                if view.stopped() {
                    return;
                }
                places.clear();
                places.extend(all.by_ref().take(colors.len()));
                view.light(&places, &mut seen);
                colors.copy_from_slice(&seen);
            }
        };
        let rows = colors.par_chunks_exact_mut(columns).enumerate();
        rows.with_max_len(1).for_each(look);
        Ok(Self {
            first_row,
            columns,
            colors,
        })
    }

    /// How many corners there are.
    pub fn len(&self) -> usize {
        self.colors.len()
    }

    /// Visits the blocks of some rows of the picture, column by column.
    pub fn for_each_block(&self, rows: &Range<u32>, mut visit: impl FnMut(Cell)) {
        let start = ((rows.start - self.first_row) / 2) as usize;
        let end = start + rows.len().div_ceil(2);
        let bends: Vec<_> = (start..=end).map(|y| self.bends(y)).collect();
        for x in 0..self.columns - 1 {
            for (y, bends) in (start..end).zip(bends.windows(2)) {
                let (above, below) = (self.row(y), self.row(y + 1));
                let corners = [above[x], above[x + 1], below[x], below[x + 1]];
                let bend = |i: usize| bends[i][x].max(bends[i][x + 1]);
                let (column, row) = (2 * x as u32, self.first_row + 2 * y as u32);
                visit(Cell::block(column, row, corners, bend(0).max(bend(1))));
            }
        }
    }

    fn row(&self, y: usize) -> &[Color] {
        &self.colors[y * self.columns..][..self.columns]
    }

    /// How far the light at each corner of a row is from lying evenly between its
    /// neighbours, across or down, in any channel.
    fn bends(&self, y: usize) -> Vec<f32> {
        let bend = |[a, b, c]: [Color; 3]| {
            let b = lanes(b);
            (lanes(a) + lanes(c) - (b + b)).abs()
        };
        let here = self.row(y);
        let rows = around(y, self.colors.len() / self.columns).map(|y| self.row(y));
        let greatest = |x: usize| {
            let across = bend(around(x, self.columns).map(|x| here[x]));
            let down = bend(rows.map(|row| row[x]));
            greatest_channel(across.max(down))
        };
        (0..self.columns).map(greatest).collect()
    }
}

/// A place and its neighbours, of so many in a row; at the ends that of the next one
/// inside.
const fn around(i: usize, places: usize) -> [usize; 3] {
    match i {
        _ if places == 2 => [0, 0, 1],
        0 => [0, 1, 2],
        _ if i + 1 == places => [i - 2, i - 1, i],
        _ => [i - 1, i, i + 1],
    }
}

#[cfg(test)]
mod tests {
    use super::super::drawn::Drawn;
    use super::super::place::Place;
    use super::*;

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
        lattice.for_each_block(&rows, |block| blocks.push(block));
        blocks
    }

    #[test]
    fn corners_of_blocks_are_looked_at_once_and_few_together() {
        for (width, height, columns, rows) in
            [(5, 3, 4, 3), (4, 4, 3, 3), (1, 1, 2, 2), (199, 2, 101, 2)]
        {
            let view = Drawn::new(ramp);
            let lattice = Lattice::new(Size::new(width, height).unwrap(), 7, &view).unwrap();
            let corners =
                (0..columns).flat_map(|x| (0..rows).map(move |y| (512 * x, 1792 + 512 * y)));
            let (asked, together) = view.asked();
            assert_eq!(asked, corners.collect::<Vec<_>>());
            assert_eq!(lattice.len(), asked.len());
            assert!(together <= TOGETHER);
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
        let lattice = lattice(5, 5, 7, ramp);
        let pixels = |rows| {
            blocks(&lattice, rows)
                .iter()
                .map(Cell::pixel)
                .collect::<Vec<_>>()
        };
        assert_eq!(
            pixels(7..11),
            [(0, 7), (0, 9), (2, 7), (2, 9), (4, 7), (4, 9)]
        );
        assert_eq!(
            pixels(9..12),
            [(0, 9), (0, 11), (2, 9), (2, 11), (4, 9), (4, 11)]
        );
        assert_eq!(pixels(11..12), [(0, 11), (2, 11), (4, 11)]);
        for Cell {
            corners,
            x,
            y,
            depth,
            ..
        } in blocks(&lattice, 7..12)
        {
            let places = [(x, y), (x + 512, y), (x, y + 512), (x + 512, y + 512)];
            assert_eq!((corners, depth), (places.map(ramp), 0));
        }
    }

    #[test]
    fn light_that_changes_evenly_does_not_bend() {
        let lattice = lattice(12, 8, 0, ramp);
        for y in 0..5 {
            assert_eq!(lattice.bends(y), [0.0; 7]);
        }
        for block in blocks(&lattice, 0..8) {
            assert_eq!((block.seen, block.hidden), (0.0, 0.0));
        }
    }

    /// In the middle of 7 x 5 corners.
    fn white_corner(place: Place) -> Color {
        if place == (3 * 512, 2 * 512) {
            Color::WHITE
        } else {
            Color::BLACK
        }
    }

    #[test]
    fn light_bends_twice_as_far_at_a_white_corner_as_beside_it() {
        let lattice = lattice(12, 8, 0, white_corner);
        // Those above and below are at the ends, and like their neighbours inside.
        let beside = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
        let across = [0.0, 0.0, 1.0, 2.0, 1.0, 0.0, 0.0];
        let expected = [beside, beside, across, beside, beside];
        assert_eq!([0, 1, 2, 3, 4].map(|y| lattice.bends(y)), expected);
    }

    /// The square of the bend, in three channels of four pixels.
    #[test]
    fn a_block_could_hide_what_bends_at_any_of_its_corners() {
        let lattice = lattice(12, 8, 0, white_corner);
        let hidden: Vec<_> = (blocks(&lattice, 0..8).iter())
            .map(|block| block.hidden)
            .collect();
        let (none, far, near) = ([0.0; 4], [0.0, 12.0, 12.0, 0.0], [12.0, 48.0, 48.0, 12.0]);
        assert_eq!(hidden, [none, far, near, near, far, none].concat());
    }

    /// Green, which is between the others.
    #[test]
    fn two_corners_in_a_row_bend_by_what_they_differ() {
        let lattice = lattice(2, 1, 0, |(x, y)| {
            Color::GREEN * f64::from(x / 512 + y / 256)
        });
        assert_eq!([0, 1].map(|y| lattice.bends(y)), [[2.0; 2]; 2]);
    }

    #[test]
    fn places_at_the_ends_have_the_neighbours_of_the_next_inside() {
        assert_eq!([0, 1].map(|i| around(i, 2)), [[0, 0, 1]; 2]);
        assert_eq!([0, 1, 2].map(|i| around(i, 3)), [[0, 1, 2]; 3]);
        let of_five = [[0, 1, 2], [0, 1, 2], [1, 2, 3], [2, 3, 4], [2, 3, 4]];
        assert_eq!([0, 1, 2, 3, 4].map(|i| around(i, 5)), of_five);
    }
}
