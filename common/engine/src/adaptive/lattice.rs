//! `Lattice`: the light at the corners of cells of one size, by which they are judged
//! first.

use std::mem;
use std::ops::Range;

use common::{Color, Error, Size};
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;

use super::View;
use super::cell::{BLOCK, Cell, PIXEL, greatest_channel, lanes};
use crate::BATCH;

/// Colours row after row, a cell apart. The last ones may lie beside the picture, where
/// its sides are no multiples of that.
pub struct Lattice {
    grid: Grid,
    colors: Vec<Color>,
    samples: u64,
}

/// Where the corners of cells of one depth lie.
#[derive(Clone, Copy)]
struct Grid {
    /// The pixel that the first cell begins with.
    left: u32,
    top: u32,
    depth: u8,
    columns: usize,
    rows: usize,
}

impl Grid {
    fn new(columns: &Range<u32>, rows: &Range<u32>, depth: u8) -> Self {
        let corners = |pixels: &Range<u32>| pixels.len().div_ceil(side(depth) as usize) + 1;
        Self {
            left: columns.start,
            top: rows.start,
            depth,
            columns: corners(columns),
            rows: corners(rows),
        }
    }

    const fn corners(&self) -> usize {
        self.columns * self.rows
    }

    /// Looks at the corners in these columns of a row.
    fn look(
        &self,
        row: usize,
        mut columns: impl Iterator<Item = usize>,
        colors: &mut [Color],
        view: &impl View,
    ) {
        let side = PIXEL * side(self.depth);
        let (left, y) = (PIXEL * self.left, PIXEL * self.top + side * row as u32);
        let (mut some, mut places, mut seen) = (Vec::new(), Vec::new(), Vec::new());
        while !view.stopped() {
            some.clear();
            some.extend(columns.by_ref().take(BATCH));
            if some.is_empty() {
                return;
            }
            places.clear();
            places.extend(some.iter().map(|column| (left + side * *column as u32, y)));
            view.light(&places, &mut seen);
            for (column, color) in some.iter().zip(&seen) {
                colors[*column] = *color;
            }
        }
    }
}

/// The side of cells of this depth that are not smaller than a pixel, in pixels.
const fn side(depth: u8) -> u32 {
    BLOCK >> depth
}

impl Lattice {
    /// Looks at the corners of all blocks of a picture of this size, or of rows from
    /// `first_row`.
    pub fn new(size: Size, first_row: u32, view: &impl View) -> Result<Self, Error> {
        let grid = Grid::new(
            &(0..size.width()),
            &(first_row..first_row + size.height()),
            0,
        );
        let mut colors = Vec::new();
        let memory = colors.try_reserve_exact(grid.corners());
        memory.map_err(|_| Error::Memory { size })?;
        colors.resize(grid.corners(), Color::BLACK);
        let rows = colors.par_chunks_exact_mut(grid.columns).enumerate();
        (rows.with_max_len(1)).for_each(|(row, colors)| {
            grid.look(row, 0..grid.columns, colors, view);
        });
        let samples = grid.corners() as u64;
        Ok(Self {
            grid,
            colors,
            samples,
        })
    }

    /// Looks at the corners of the cells of this depth in part of the picture that these
    /// are the blocks of, from one of them on. Their own corners are known.
    pub fn part(
        &self,
        columns: &Range<u32>,
        rows: &Range<u32>,
        depth: u8,
        view: &impl View,
    ) -> Self {
        let grid = Grid::new(columns, rows, depth);
        let mut colors = vec![Color::BLACK; grid.corners()];
        let mut samples = 0;
        let (left, top) = (grid.left - self.grid.left, grid.top - self.grid.top);
        let between = (BLOCK / side(depth)) as usize;
        for (row, colors) in colors.chunks_exact_mut(grid.columns).enumerate() {
            let mut known = 0;
            if row.is_multiple_of(between) {
                let corners = self.row((top / BLOCK) as usize + row / between);
                let corners = &corners[(left / BLOCK) as usize..];
                for (color, corner) in colors.iter_mut().step_by(between).zip(corners) {
                    *color = *corner;
                    known += 1;
                }
            }
            let is_unknown = |column: &usize| known == 0 || !column.is_multiple_of(between);
            grid.look(row, (0..grid.columns).filter(is_unknown), colors, view);
            samples += (grid.columns - known) as u64;
        }
        Self {
            grid,
            colors,
            samples,
        }
    }

    /// How many cells lie side by side.
    pub fn cells_in_a_row(&self) -> usize {
        self.grid.columns - 1
    }

    /// How many corners were looked at.
    pub fn samples(&self) -> u64 {
        self.samples
    }

    /// Visits the cells in some rows of the picture, column by column.
    pub fn for_each_cell(&self, rows: &Range<u32>, mut visit: impl FnMut(Cell)) {
        let Grid {
            left, top, depth, ..
        } = self.grid;
        let side = side(depth);
        let start = ((rows.start - top) / side) as usize;
        let end = start + rows.len().div_ceil(side as usize);
        let bends: Vec<_> = (start..=end).map(|y| self.bends(y)).collect();
        for x in 0..self.cells_in_a_row() {
            for (y, bends) in (start..end).zip(bends.windows(2)) {
                let (above, below) = (self.row(y), self.row(y + 1));
                let corners = [above[x], above[x + 1], below[x], below[x + 1]];
                let bend = |i: usize| bends[i][x].max(bends[i][x + 1]);
                let pixel = (left + side * x as u32, top + side * y as u32);
                visit(Cell::new(pixel, depth, corners, bend(0).max(bend(1))));
            }
        }
    }

    /// Where the cells are blocks: what their left and right sides show of a row of the
    /// picture, light that changes evenly between corners.
    pub fn sides(&self, row: u32) -> impl Iterator<Item = [Color; 2]> {
        let below_top = row - self.grid.top;
        let (y, row) = (below_top / BLOCK, below_top % BLOCK);
        let (above, below) = (self.row(y as usize), self.row(y as usize + 1));
        let side = move |(above, below): (&Color, &Color)| middle(*above, *below, row);
        let mut sides = above.iter().zip(below).map(side);
        let mut left = sides.next().unwrap_or_default();
        sides.map(move |right| [mem::replace(&mut left, right), right])
    }

    fn row(&self, y: usize) -> &[Color] {
        &self.colors[y * self.grid.columns..][..self.grid.columns]
    }

    /// How far the light at each corner of a row is from lying evenly between its
    /// neighbours, across or down, in any channel. At the ends, of which only one side is
    /// known, it may be twice as far as next to them: of a line that runs along, that is
    /// known of its inner edge.
    fn bends(&self, y: usize) -> Vec<f32> {
        let bend = |[a, b, c]: [Color; 3], is_end| {
            let b = lanes(b);
            let bend = (lanes(a) + lanes(c) - (b + b)).abs();
            if is_end { bend + bend } else { bend }
        };
        let here = self.row(y);
        let rows = around(y, self.grid.rows).map(|y| self.row(y));
        let greatest = |x: usize| {
            let columns = around(x, self.grid.columns);
            let across = bend(columns.map(|x| here[x]), is_end(x, self.grid.columns));
            let down = bend(rows.map(|row| row[x]), is_end(y, self.grid.rows));
            greatest_channel(across.max(down))
        };
        (0..self.grid.columns).map(greatest).collect()
    }
}

const fn is_end(i: usize, places: usize) -> bool {
    i == 0 || i + 1 == places
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

/// The colour on the way from one to the other where this pixel of a block has its
/// middle: 1/8, 3/8, 5/8 or 7/8 of the way. Between equal ones it is exactly that.
#[inline]
pub fn middle(a: Color, b: Color, pixel: u32) -> Color {
    let half = |a: Color, b: Color| (a + b) * 0.5;
    let middle = half(a, b);
    let end = if pixel < BLOCK / 2 { a } else { b };
    let quarter = half(end, middle);
    let at_the_end = pixel == 0 || pixel == BLOCK - 1;
    half(if at_the_end { end } else { middle }, quarter)
}

#[cfg(test)]
mod tests;
