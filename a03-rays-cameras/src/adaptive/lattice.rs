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
