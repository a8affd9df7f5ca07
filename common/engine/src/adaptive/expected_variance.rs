//! The expected variance of the samples of each pixel.
//!
//! The samples of one pixel are too few to show it: where a needle covers a tenth of a pixel,
//! four samples mostly agree. So the variance of its neighbours counts, too, because their edge may
//! touch the pixel. With a single pair of samples, or one in its middle, the curvature of the light
//! stands in for the variance: the difference from the mean of its neighbours on both sides.

use common::Color;
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;

use super::pixel::{Pixel, dot};

/// The expected variance of a sample of each pixel, added up over the channels.
///
/// `own` are the variances of the pixels without their neighbours. They are empty at first; those
/// of pixels with no more than the sample in their middle stay.
pub fn expected_variances(pixels: &[Pixel], width: usize, own: &mut Vec<f32>) -> Vec<f32> {
    let is_first = own.is_empty();
    own.resize(pixels.len(), 0.0);
    by_row(own, width, &|row, own| {
        for (column, own) in own.iter_mut().enumerate() {
            if is_first || pixels[row * width + column].pairs() > 0 {
                *own = own_variance(pixels, width, row, column);
            }
        }
    });
    let mut variances = vec![0.0; pixels.len()];
    by_row(&mut variances, width, &|row, variances| {
        let rows = row.saturating_sub(1) * width..pixels.len().min((row + 2) * width);
        let mut largest_in_column = vec![0.0_f32; width];
        for own in own[rows].chunks_exact(width) {
            for (largest, own) in largest_in_column.iter_mut().zip(own) {
                *largest = largest.max(*own);
            }
        }
        for (column, variance) in variances.iter_mut().enumerate() {
            let around = &largest_in_column[column.saturating_sub(1)..width.min(column + 2)];
            let around = around.iter().copied().fold(0.0, f32::max);
            let (pixel, own) = (&pixels[row * width + column], own[row * width + column]);
            if !pixel.is_background() && !is_glaring(pixel, own) {
                *variance = own.max(of_neighbours(around, pixel.pairs()));
            }
        }
    });
    variances
}

/// The variance of a pixel without its neighbours, or else the curvature of the light; 0 where it
/// is not finite.
fn own_variance(pixels: &[Pixel], width: usize, row: usize, column: usize) -> f32 {
    let i = row * width + column;
    if pixels[i].is_background() {
        return 0.0;
    }
    let variance = pixels[i].variance().unwrap_or_else(|| {
        let middle = pixels[i].mean();
        let left = (column > 0).then(|| &pixels[i - 1]);
        let right = (column + 1 < width).then(|| &pixels[i + 1]);
        let above = i.checked_sub(width).map(|above| &pixels[above]);
        let below = pixels.get(i + width);
        curvature(middle, left, right).max(curvature(middle, above, below))
    });
    if variance.is_finite() { variance } else { 0.0 }
}

/// The squared difference of the light from the mean of two opposite neighbours; at the border from
/// the light of the only neighbour.
fn curvature(middle: Color, before: Option<&Pixel>, after: Option<&Pixel>) -> f32 {
    let expected = match (before, after) {
        (Some(before), Some(after)) => (before.mean() + after.mean()) * 0.5,
        (Some(only), None) | (None, Some(only)) => only.mean(),
        (None, None) => middle,
    };
    let difference = middle - expected;
    dot(difference, difference) as f32
}

/// The expected variance because of the largest variance of a neighbour. A straight edge there
/// cuts off a corner of this pixel that none of `n` samples has hit: its area is about `1/n` at
/// most.
fn of_neighbours(variance: f32, pairs: u32) -> f32 {
    variance / (8 * pairs.max(1)) as f32
}

/// Whether a pixel is too bright to show its variance: all channels are above 1 by more than three
/// standard deviations of their mean.
fn is_glaring(pixel: &Pixel, variance: f32) -> bool {
    let mean = pixel.mean();
    let is_above = |least: f64| mean.channels().into_iter().all(|channel| channel > least);
    let of_mean = || f64::from(variance) / f64::from((2 * pixel.pairs()).max(1));
    is_above(1.0) && is_above(1.0 + 3.0 * of_mean().sqrt())
}

/// Computes rows in parallel.
fn by_row(all: &mut [f32], width: usize, fill: &(dyn Fn(usize, &mut [f32]) + Sync)) {
    let rows = all.par_chunks_exact_mut(width).enumerate();
    rows.for_each(|(row, values)| fill(row, values));
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of a picture of 5 x 5 pixels with these pairs of samples.
    fn variances(pairs: u32, light: impl Fn(usize, usize, u32) -> [f64; 2]) -> Vec<f32> {
        let pixel = |i: usize| {
            let mut pixel = Pixel::NONE;
            for n in 0..pairs {
                let pair = light(i % 5, i / 5, n).map(Color::gray);
                pixel.merge(&Pixel::of_pair(pair));
            }
            pixel
        };
        let pixels: Vec<_> = (0..25).map(pixel).collect();
        expected_variances(&pixels, 5, &mut Vec::new())
    }

    #[test]
    fn a_gradient_has_no_variance_inside() {
        let gradient = |x: usize, y: usize, _| [(2 * x + y) as f64 / 32.0; 2];
        assert_eq!(variances(1, gradient)[12], 0.0);
        assert!(variances(2, gradient).iter().all(|v| *v == 0.0));
    }
}
