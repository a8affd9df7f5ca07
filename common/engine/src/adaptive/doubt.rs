//! `doubt`: how much the samples of each pixel are expected to differ.
//!
//! The samples of one pixel say little: where a needle covers a tenth of a pixel, four
//! samples mostly agree. So a pixel is doubted as well where its neighbours' samples differ,
//! because their edge may touch it. With a single pair of samples, or one in its middle, it
//! is doubted where its light is not halfway between its neighbours on both sides.

use common::Color;
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;

use super::pixel::{Pixel, dot};

/// The doubt of each pixel: the expected variance of a sample, added up over the channels.
///
/// `spreads` are the doubts of pixels by themselves. They are empty at first; those of pixels
/// of which only the middle is known stay.
pub fn doubts(pixels: &[Pixel], width: usize, spreads: &mut Vec<f32>) -> Vec<f32> {
    let row_of = |row: usize| pixels.chunks_exact(width).nth(row).unwrap_or_default();
    let is_first = spreads.is_empty();
    spreads.resize(pixels.len(), 0.0);
    by_row(spreads, width, |row, spreads| {
        let above = row.checked_sub(1).map_or(&[][..], row_of);
        let (row, below) = (row_of(row), row_of(row + 1));
        for (column, spread) in spreads.iter_mut().enumerate() {
            if row[column].pairs() == 0 && !is_first {
                continue;
            }
            *spread = row[column].variance().unwrap_or_else(|| {
                let left = column.checked_sub(1).and_then(|left| row.get(left));
                let middle = row[column].mean();
                bend(middle, left, row.get(column + 1)).max(bend(
                    middle,
                    above.get(column),
                    below.get(column),
                ))
            });
            if !spread.is_finite() {
                *spread = 0.0;
            }
        }
    });
    let mut doubts = vec![0.0; pixels.len()];
    by_row(&mut doubts, width, |row, doubts| {
        let rows = row.saturating_sub(1) * width..pixels.len().min((row + 2) * width);
        let mut column_most = vec![0.0_f32; width];
        for spreads in spreads[rows].chunks_exact(width) {
            for (most, spread) in column_most.iter_mut().zip(spreads) {
                *most = most.max(*spread);
            }
        }
        for (column, doubt) in doubts.iter_mut().enumerate() {
            let around = &column_most[column.saturating_sub(1)..width.min(column + 2)];
            let around = around.iter().copied().fold(0.0, f32::max);
            let (pixel, spread) = (&pixels[row * width + column], spreads[row * width + column]);
            if !is_glaring(pixel, spread) {
                *doubt = spread.max(of_neighbours(around, pixel.pairs()));
            }
        }
    });
    doubts
}

/// How far the light is from the mean of two opposite neighbours, squared; at the border from the
/// light of the only neighbour.
fn bend(middle: Color, before: Option<&Pixel>, after: Option<&Pixel>) -> f32 {
    let expected = match (before, after) {
        (Some(before), Some(after)) => (before.mean() + after.mean()) * 0.5,
        (Some(only), None) | (None, Some(only)) => only.mean(),
        (None, None) => middle,
    };
    let apart = middle - expected;
    dot(apart, apart) as f32
}

/// The doubt because of the largest variance next door. A straight edge there cuts off a
/// corner of this pixel that none of `n` samples has met: its area is about `1/n` at most.
fn of_neighbours(variance: f32, pairs: u32) -> f32 {
    variance / (8 * pairs.max(1)) as f32
}

/// Whether a pixel is so bright that its changes do not show: all channels are above 1 by
/// more than three standard deviations of their mean.
fn is_glaring(pixel: &Pixel, variance: f32) -> bool {
    let mean = pixel.mean();
    let is_above = |least: f64| mean.channels().into_iter().all(|channel| channel > least);
    let of_mean = || f64::from(variance) / f64::from((2 * pixel.pairs()).max(1));
    is_above(1.0) && is_above(1.0 + 3.0 * of_mean().sqrt())
}

/// Computes rows in parallel.
fn by_row(all: &mut [f32], width: usize, fill: impl Fn(usize, &mut [f32]) + Sync) {
    let rows = all.par_chunks_exact_mut(width).enumerate();
    rows.for_each(|(row, values)| fill(row, values));
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A picture of 5 x 5 pixels with these pairs of samples.
    fn doubts_of(pairs: u32, light: impl Fn(usize, usize, u32) -> [f64; 2]) -> Vec<f32> {
        let pixel = |i: usize| {
            let mut pixel = Pixel::NONE;
            for n in 0..pairs {
                let pair = light(i % 5, i / 5, n).map(Color::gray);
                pixel.merge(&Pixel::of_pair(pair));
            }
            pixel
        };
        doubts(&(0..25).map(pixel).collect::<Vec<_>>(), 5, &mut Vec::new())
    }

    #[test]
    fn even_light_raises_no_doubt_inside() {
        let slope = |x: usize, y: usize, _| [(2 * x + y) as f64 / 32.0; 2];
        let doubts = doubts_of(1, slope);
        assert_eq!(doubts[12], 0.0);
        assert!(doubts_of(2, slope).iter().all(|doubt| *doubt == 0.0));
    }
}
