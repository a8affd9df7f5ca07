//! `Sampler`: the positions of the samples in each pixel.

use common::Size;

/// Places the samples of every pixel.
pub trait Sampler: Sync {
    /// Number of samples in a pixel: at least one.
    fn samples(&self) -> u32;

    /// The position of sample `i`, counted from 0, in the pixel of this column and row:
    /// from its upper left corner, rightwards and downwards, each at least 0 and less
    /// than 1.
    fn place(&self, i: u32, column: u32, row: u32) -> (f64, f64);
}

/// The position in the picture of a position in the pixel of this column and row, which are counted
/// from the upper left corner: in the coordinates of the camera, from pixel middles and upwards.
pub(crate) fn image_position(
    size: Size,
    (column, row): (u32, u32),
    (dx, dy): (f64, f64),
) -> (f64, f64) {
    let x = f64::from(column) + (dx - 0.5);
    let y = f64::from(size.height() - 1 - row) - (dy - 0.5);
    (x, y)
}
