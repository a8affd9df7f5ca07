//! `Strip`: some rows of the picture, whose cells are divided by one thread.

use std::ops::Range;

use common::Color;

use super::View;
use super::block::Block;
use super::cell::{BLOCK, Cell, PIXEL_DEPTH, mean};
use super::crosses::{CELLS, crosses};
use super::experience::{ByDepth, Experience};
use super::lattice::{Lattice, middle};
use super::level::Level;

/// So many rows there are in a strip, and columns in each of its tiles.
pub const TILE: u32 = 16;

/// What is known of the rows.
pub struct Strip<'a> {
    /// The blocks of the picture.
    lattice: &'a Lattice,
    width: u32,
    rows: Range<u32>,
    /// The blocks of which more is known than their corners, ...
    blocks: Vec<Block>,
    /// ... and of each in the rows, row after row, which of these it is.
    known: Vec<Option<u32>>,
    /// The cells that may be divided.
    cells: Vec<Cell>,
    /// Of all cells, what they show and what they could hide.
    seen: ByDepth,
    hidden: ByDepth,
    experience: Experience,
    samples: u64,
    depth: u8,
}

impl<'a> Strip<'a> {
    /// Rows of the picture, of which nothing is known but the lattice.
    pub fn new(lattice: &'a Lattice, width: u32, rows: Range<u32>) -> Self {
        Self {
            lattice,
            width,
            rows,
            blocks: Vec::new(),
            known: vec![None; (TILE / BLOCK) as usize * lattice.cells_in_a_row()],
            cells: Vec::new(),
            seen: ByDepth::default(),
            hidden: ByDepth::default(),
            experience: Experience::default(),
            samples: 0,
            depth: PIXEL_DEPTH,
        }
    }

    /// How many pixels are in each row.
    pub fn width(&self) -> usize {
        self.width as usize
    }

    /// Which rows they are.
    pub fn rows(&self) -> Range<u32> {
        self.rows.clone()
    }

    /// What divided cells have shown.
    pub fn experience(&self) -> &Experience {
        &self.experience
    }

    /// How many places were looked at.
    pub fn samples(&self) -> u64 {
        self.samples
    }

    /// The depth of the smallest cells.
    pub fn depth(&self) -> u8 {
        self.depth
    }

    /// The estimated squared error of the pixels, summed over them and the channels.
    pub fn error(&self, level: &Level) -> f64 {
        level.sum(&self.seen, &self.hidden)
    }

    /// The cells that may be divided.
    pub fn cells(&self) -> &[Cell] {
        &self.cells
    }

    /// Whether any cell is to be divided.
    pub fn is_due(&self, level: &Level) -> bool {
        self.cells.iter().any(|cell| level.is_due(cell))
    }

    /// Paints one of the rows.
    pub fn paint(&self, row: u32, pixels: &mut [Color]) {
        let below_top = row - self.rows.start;
        let known = &self.known[self.index(0, below_top)..];
        let sides = self.lattice.sides(row);
        for ((pixels, block), [left, right]) in
            pixels.chunks_mut(BLOCK as usize).zip(known).zip(sides)
        {
            let colors = match block {
                Some(block) => self.blocks[*block as usize].row(below_top % BLOCK),
                None => [0, 1, 2, 3].map(|pixel| middle(left, right, pixel)),
            };
            pixels.copy_from_slice(&colors[..pixels.len()]);
        }
    }

    /// Takes up the blocks; or smaller cells, where blocks may hide something.
    pub fn begin(&mut self, level: &Level, view: &impl View) {
        let rows = self.rows();
        let tiles = (0..self.width).step_by(TILE as usize);
        let may_hide = |x, depth| view.may_hide((x, rows.start), TILE, narrow(depth));
        let depths = |x| (0..PIXEL_DEPTH).find(|depth| !may_hide(x, *depth));
        let depths: Vec<_> = tiles.map(|x| depths(x).unwrap_or(PIXEL_DEPTH)).collect();

        let mut columns = 0..0;
        for tiles in depths.chunk_by(|a, b| a == b) {
            columns = columns.end..self.width.min(columns.end + TILE * tiles.len() as u32);
            let depth = tiles[0];
            if depth > 0 {
                let part = self.lattice.part(&columns, &rows, depth, view);
                self.samples += part.samples();
                part.for_each_cell(&rows, |cell| {
                    self.show(&cell);
                    self.take_up(cell, level);
                });
            }
        }
        self.lattice.for_each_cell(&rows, |block| {
            if depths[(block.pixel().0 / TILE) as usize] == 0 {
                self.take_up(block, level);
            }
        });
    }

    /// Divides the cells that are due, then those of their parts that are, and so on, so
    /// many times. Returns whether any was.
    pub fn divide(&mut self, times: u8, level: &Level, view: &impl View) -> bool {
        let (mut first, mut any) = (0, false);
        for _ in 0..times {
            let Some(parts) = self.divide_from(first, level, view) else {
                break;
            };
            (first, any) = (parts, true);
        }
        any
    }

    /// Divides those cells that are due from the first one on. Returns from where on their
    /// parts are, behind all others, if any was.
    fn divide_from(&mut self, first: usize, level: &Level, view: &impl View) -> Option<usize> {
        let (before, mut kept, mut any) = (self.cells.len(), first, false);
        let mut due = Vec::with_capacity(CELLS);
        for i in first..before {
            let cell = self.cells[i];
            if level.is_due(&cell) {
                any = true;
                due.push(cell);
            } else if level.keeps(&cell) {
                self.cells[kept] = cell;
                kept += 1;
            }
            if due.len() == CELLS {
                self.divide_all(&due, level, view);
                due.clear();
            }
        }
        self.divide_all(&due, level, view);
        self.cells.drain(kept..before);
        any.then_some(kept)
    }

    fn divide_all(&mut self, cells: &[Cell], level: &Level, view: &impl View) {
        if view.stopped() {
            return;
        }
        let (crosses, samples) = crosses(cells, view);
        self.samples += samples;
        let mut changes = Vec::with_capacity(CELLS);
        for (cell, cross) in cells.iter().zip(&crosses) {
            let parts = cell.divided(cross);
            changes.push((cell, self.show_parts(cell, &parts)));
            self.count(cell, -1.0);
            for part in parts {
                self.take_up(part, level);
            }
        }
        for of_pixel in changes.chunk_by(|(a, _), (b, _)| a.pixel() == b.pixel()) {
            self.experience.learn(of_pixel);
        }
    }

    /// Paints the parts of a cell. Returns by how much its light changes.
    fn show_parts(&mut self, cell: &Cell, parts: &[Cell; 4]) -> Color {
        let change = mean(parts.each_ref().map(Cell::light)) - cell.light();
        if cell.depth < PIXEL_DEPTH {
            for part in parts {
                self.show(part);
            }
        } else {
            let (block, pixel) = self.block(cell);
            *block.pixel(pixel) += change * cell.area();
        }
        self.depth = self.depth.max(cell.depth + 1);
        change
    }

    /// Paints a part of a block that is not smaller than a pixel.
    fn show(&mut self, cell: &Cell) {
        let (block, pixel) = self.block(cell);
        block.show(pixel, cell);
    }

    /// The pixels of the block that a cell lies in, and where it begins there.
    fn block(&mut self, cell: &Cell) -> (&mut Block, (u32, u32)) {
        let (column, row) = cell.pixel();
        let below_top = row - self.rows.start;
        let index = self.index(column / BLOCK, below_top);
        let block = *self.known[index].get_or_insert_with(|| {
            self.blocks.push(Block::default());
            self.blocks.len() as u32 - 1
        });
        let pixel = (column % BLOCK, below_top % BLOCK);
        (&mut self.blocks[block as usize], pixel)
    }

    /// The number of a block in its row, at this row below the top.
    fn index(&self, block: u32, below_top: u32) -> usize {
        (below_top / BLOCK) as usize * self.lattice.cells_in_a_row() + block as usize
    }

    fn take_up(&mut self, cell: Cell, level: &Level) {
        self.count(&cell, 1.0);
        if level.keeps(&cell) {
            self.cells.push(cell);
        }
    }

    /// Counts what a cell shows and could hide so many times.
    fn count(&mut self, cell: &Cell, times: f64) {
        let depth = usize::from(cell.depth);
        self.seen[depth] += times * f64::from(cell.seen);
        self.hidden[depth] += times * f64::from(cell.hidden);
    }
}

/// In pixels: what is so narrow may lie between the corners of all cells of this depth.
/// (A disc is met by one of them if it is the root of two wider than they are.)
fn narrow(depth: u8) -> f64 {
    1.5 * f64::from(BLOCK >> depth)
}

#[cfg(test)]
mod tests;
