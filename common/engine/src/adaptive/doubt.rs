//! `doubt`: how much the samples of each pixel are expected to differ.
//!
//! The samples of one pixel say little: where a needle covers a tenth of a pixel, four
//! samples mostly agree. So a pixel is doubted as well where its neighbours' samples differ,
//! because their edge may touch it. With a single pair of samples it is doubted where its
//! light is not halfway between its neighbours on both sides.

use common::Color;
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;

use super::pixel::{Pixel, dot};

/// The doubt of each pixel: the expected variance of a sample, added up over the channels.
pub fn doubts(pixels: &[Pixel], width: usize) -> Vec<f32> {
    let row_of = |row: usize| pixels.chunks_exact(width).nth(row).unwrap_or_default();
    let spreads = by_row(pixels.len(), width, |row, spreads| {
        let above = row.checked_sub(1).map_or(&[][..], row_of);
        let (row, below) = (row_of(row), row_of(row + 1));
        for (column, spread) in spreads.iter_mut().enumerate() {
            *spread = row[column].variance().unwrap_or_else(|| {
                let left = column.checked_sub(1).and_then(|left| row.get(left));
                let middle = row[column].mean();
                bend(middle, left, row.get(column + 1)).max(bend(
                    middle,
                    above.get(column),
                    below.get(column),
                ))
            });
            if !spread.is_finite() || is_glaring(&row[column], *spread) {
                *spread = 0.0;
            }
        }
    });
    by_row(pixels.len(), width, |row, doubts| {
        let rows = row.saturating_sub(1) * width..pixels.len().min((row + 2) * width);
        for (column, doubt) in doubts.iter_mut().enumerate() {
            let columns = column.saturating_sub(1)..width.min(column + 2);
            let around = spreads[rows.clone()].chunks_exact(width);
            let around = around.flat_map(|row| &row[columns.clone()]);
            let around = around.copied().fold(0.0, f32::max);
            let i = row * width + column;
            *doubt = spreads[i].max(of_neighbours(around, pixels[i].pairs()));
        }
    })
}

/// How far the light is from halfway between that of two opposite neighbours, squared; at
/// the border from that of the only one.
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
    variance / (8 * pairs) as f32
}

/// Whether a pixel is so bright that its changes do not show: all channels are above 1 by
/// more than three standard deviations of their mean.
fn is_glaring(pixel: &Pixel, variance: f32) -> bool {
    let of_mean = f64::from(variance) / f64::from(2 * pixel.pairs());
    let least = 1.0 + 3.0 * of_mean.sqrt();
    pixel.mean().channels().into_iter().all(|c| c > least)
}

/// Computes rows in parallel.
fn by_row(pixels: usize, width: usize, fill: impl Fn(usize, &mut [f32]) + Sync) -> Vec<f32> {
    let mut all = vec![0.0; pixels];
    let rows = all.par_chunks_exact_mut(width).enumerate();
    rows.for_each(|(row, values)| fill(row, values));
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A picture of 5 x 5 pixels with these pairs of samples.
    fn doubts_of(pairs: u32, light: impl Fn(usize, usize, u32) -> [f64; 2]) -> Vec<f32> {
        let pixel = |i: usize| {
            let mut pixel = Pixel::NONE;
            for n in 0..pairs {
                pixel.add(light(i % 5, i / 5, n).map(Color::gray));
            }
            pixel
        };
        doubts(&(0..25).map(pixel).collect::<Vec<_>>(), 5)
    }

    #[test]
    fn even_light_raises_no_doubt_inside() {
        let slope = |x: usize, y: usize, _| [(2 * x + y) as f64 / 32.0; 2];
        let doubts = doubts_of(1, slope);
        assert_eq!(doubts[12], 0.0);
        assert!(doubts_of(2, slope).iter().all(|doubt| *doubt == 0.0));
    }

    /// A single pair in which both samples are 1 bends by 1, in each of three channels. Its
    /// neighbours bend by a half, and are doubted more for that.
    #[test]
    fn a_deviating_pixel_raises_doubts_around_it() {
        let doubts = doubts_of(1, |x, y, _| [f64::from(u8::from((x, y) == (2, 2))); 2]);
        assert_eq!(doubts[12], 3.0);
        assert_eq!(doubts[13], 0.75);
        assert_eq!(doubts[6], 3.0 / 8.0);
        assert_eq!(doubts[0], 0.0);
    }

    /// Of two pairs with the sums 0 and 1, the sums differ from their mean by a half.
    #[test]
    fn two_pairs_show_a_variance() {
        let one = |x, y, n| [f64::from(u8::from((x, y, n) == (2, 2, 1))), 0.0];
        let doubts = doubts_of(2, one);
        assert_eq!((doubts[12], doubts[6]), (0.75, 0.75 / 16.0));
    }

    #[test]
    fn changes_above_white_raise_no_doubt() {
        let glare = |x: usize, _, n: u32| [5.0 + ((x + n as usize) % 2) as f64; 2];
        assert!(doubts_of(2, glare).iter().all(|doubt| *doubt == 0.0));
        let infinite = doubts_of(2, |x, _, n| {
            [if x == 2 && n == 0 { f64::NAN } else { 0.5 }; 2]
        });
        assert!(infinite.iter().all(|doubt| *doubt == 0.0));
    }
}
