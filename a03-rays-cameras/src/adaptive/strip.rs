//! `Strip`: some rows of the picture, whose cells are divided by one thread.

use std::mem;
use std::ops::Range;

use common::Color;

use super::View;
use super::cell::{Cell, Cross, mean};
use super::crosses::{CELLS, crosses};
use super::experience::{ByDepth, Experience};
use super::lattice::Lattice;
use super::level::Level;

/// So many rows there are in a strip, and columns in each of its tiles.
pub const TILE: u32 = 16;

/// What is known of the rows.
pub struct Strip {
    rows: Range<u32>,
    /// The cells that may be divided, ...
    cells: Vec<Cell>,
    /// ... and of the others the errors of what they show, and of what they could hide.
    seen: ByDepth,
    hidden: ByDepth,
    experience: Experience,
    samples: u64,
    depth: u8,
}

/// The pixels of a strip.
pub struct Pixels<'a> {
    pub first_row: u32,
    pub width: u32,
    pub colors: &'a mut [Color],
}

impl Pixels<'_> {
    /// The pixel in this column and row of the picture, if there is one.
    fn get_mut(&mut self, (x, y): (u32, u32)) -> Option<&mut Color> {
        let index = (y - self.first_row) as usize * self.width as usize + x as usize;
        self.colors.get_mut(index).filter(|_| x < self.width)
    }
}

impl Strip {
    /// Rows of the picture: an even number of them, unless they are the last.
    pub fn new(rows: Range<u32>) -> Self {
        Self {
            rows,
            cells: Vec::new(),
            seen: ByDepth::default(),
            hidden: ByDepth::default(),
            experience: Experience::default(),
            samples: 0,
            depth: 1,
        }
    }

    /// Which rows they are.
    pub fn rows(&self) -> &Range<u32> {
        &self.rows
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
        let kept: f64 = self.cells.iter().map(|cell| level.error(cell)).sum();
        level.sum(&self.seen, &self.hidden) + kept
    }

    /// The cells that may be divided.
    pub fn cells(&self) -> &[Cell] {
        &self.cells
    }

    /// Whether any cell is to be divided.
    pub fn is_due(&self, level: &Level) -> bool {
        self.cells.iter().any(|cell| level.is_due(cell))
    }

    /// Paints the blocks, as the light at their corners is. Those that may hide
    /// something are divided.
    pub fn begin(
        &mut self,
        lattice: &Lattice,
        pixels: &mut Pixels,
        level: &Level,
        view: &impl View,
    ) {
        let rows = self.rows.clone();
        let tiles = (0..pixels.width).step_by(TILE as usize);
        let may_hide: Vec<_> = tiles
            .map(|x| view.may_hide((x, rows.start), TILE))
            .collect();
        let mut hiding = Vec::with_capacity(CELLS);
        lattice.for_each_block(&rows, |block| {
            let (x, y) = block.pixel();
            if may_hide[(x / TILE) as usize] {
                hiding.push(block);
                if hiding.len() == CELLS {
                    self.divide_all(&hiding, pixels, level, view);
                    hiding.clear();
                }
                return;
            }
            let middle = block.mean();
            for (i, (x, y)) in [(x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1)]
                .into_iter()
                .enumerate()
            {
                if let Some(pixel) = pixels.get_mut((x, y)) {
                    // Light that changes evenly: the corners of a pixel are one of the
                    // block, the middles of two sides, and that of the block.
                    let corner = block.corners[i];
                    let sides = [i ^ 1, i ^ 2].map(|next| (corner + block.corners[next]) * 0.5);
                    *pixel = mean([corner, middle, sides[0], sides[1]]);
                }
            }
            self.keep(block, level);
        });
        self.divide_all(&hiding, pixels, level, view);
    }

    /// Divides the cells that are due.
    pub fn divide(&mut self, pixels: &mut Pixels, level: &Level, view: &impl View) {
        let mut cells = mem::take(&mut self.cells);
        let mut due = Vec::with_capacity(CELLS);
        cells.retain(|cell| {
            if !level.is_due(cell) {
                return self.is_kept(cell, level);
            }
            due.push(*cell);
            if due.len() == CELLS {
                self.divide_all(&due, pixels, level, view);
                due.clear();
            }
            false
        });
        self.divide_all(&due, pixels, level, view);
        // The parts.
        cells.append(&mut self.cells);
        self.cells = cells;
    }

    fn divide_all(&mut self, cells: &[Cell], pixels: &mut Pixels, level: &Level, view: &impl View) {
        if view.stopped() {
            return;
        }
        let (crosses, samples) = crosses(cells, view);
        self.samples += samples;
        let changes: Vec<_> = (cells.iter().zip(&crosses))
            .map(|(cell, cross)| (cell, self.divide_one(cell, cross, pixels, level)))
            .collect();
        for of_pixel in changes.chunk_by(|(a, _), (b, _)| a.pixel() == b.pixel()) {
            self.experience.learn(of_pixel);
        }
    }

    /// Divides a cell and paints what it shows. Returns by how much its light changes.
    fn divide_one(
        &mut self,
        cell: &Cell,
        cross: &Cross,
        pixels: &mut Pixels,
        level: &Level,
    ) -> Color {
        let parts = cell.divided(cross);
        let change = mean(parts.each_ref().map(Cell::mean)) - cell.mean();
        if cell.depth == 0 {
            for part in &parts {
                if let Some(pixel) = pixels.get_mut(part.pixel()) {
                    *pixel = part.mean();
                }
            }
        } else if let Some(pixel) = pixels.get_mut(cell.pixel()) {
            *pixel += change * cell.area();
        }
        self.depth = self.depth.max(cell.depth + 1);
        for part in parts {
            self.keep(part, level);
        }
        change
    }

    fn keep(&mut self, cell: Cell, level: &Level) {
        if self.is_kept(&cell, level) {
            self.cells.push(cell);
        }
    }

    /// Whether a cell is remembered; of one that is never divided, its error is.
    fn is_kept(&mut self, cell: &Cell, level: &Level) -> bool {
        let is_kept = level.keeps(cell);
        if !is_kept {
            let depth = usize::from(cell.depth);
            self.seen[depth] += f64::from(cell.seen);
            self.hidden[depth] += f64::from(cell.hidden);
        }
        is_kept
    }
}
