//! `Block`: the pixels of a block of which more is known than its corners.

use common::Color;

use super::cell::{BLOCK, Cell, PIXEL_DEPTH, mean};

/// Colours row after row.
#[derive(Clone, Copy, Default)]
pub struct Block([[Color; BLOCK as usize]; BLOCK as usize]);

impl Block {
    /// The pixels in this row of the block.
    pub fn row(&self, row: u32) -> [Color; BLOCK as usize] {
        self.0[row as usize]
    }

    /// The pixel in this column and row of the block.
    pub fn pixel(&mut self, (column, row): (u32, u32)) -> &mut Color {
        &mut self.0[row as usize][column as usize]
    }

    /// Paints a cell of one pixel, or of 2 x 2, that begins there.
    pub fn show(&mut self, (x, y): (u32, u32), cell: &Cell) {
        if cell.depth == PIXEL_DEPTH {
            *self.pixel((x, y)) = cell.light();
            return;
        }
        let middle = mean(cell.corners);
        for (i, at) in [(x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1)]
            .into_iter()
            .enumerate()
        {
            // Light that changes evenly: the corners of a pixel are one of the cell, the
            // middles of two sides, and that of the cell.
            let corner = cell.corners[i];
            let sides = [i ^ 1, i ^ 2].map(|next| (corner + cell.corners[next]) * 0.5);
            *self.pixel(at) = mean([corner, middle, sides[0], sides[1]]);
        }
    }
}
