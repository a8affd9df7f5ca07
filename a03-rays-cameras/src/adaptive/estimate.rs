//! How far off the pixels are, by what their samples have shown.
//!
//! The estimate rests on three things:
//!
//! - Samples that differ. The plain variance of their mean, σ²/n, is too large
//!   for evenly spread samples.
//! - Two halves of the samples, spread independently of each other. A quarter
//!   of the squared difference of their means is the error squared, on average
//!   over many pixels; what it is of σ²/n over all pixels of n samples is the
//!   factor for each of them.
//! - Neighbours. Samples that agree may do so by luck, so half a sample of the
//!   neighbours' light is added to them: a corner of the pixel that the light
//!   of n samples misses is of the order of 1/n, and rare.

use common::{Color, Image};
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;

use super::{FEW, Pixel};

/// The share of σ²/n, for each binary logarithm of the number of samples,
/// that is the squared error of the mean.
type Factors = [f64; 32];

/// A sample in the middle of a pixel that a straight edge of height h crosses is
/// off by at most h/2. Two pixels see the edge, and of its square the estimate
/// takes half.
const FACTOR_OF_ONE: f64 = 0.25;

/// Estimates the error of every pixel, and returns the sum of their squares.
pub fn estimate(image: &Image, pixels: &mut [Pixel]) -> f64 {
    let width = image.size().width() as usize;
    let factors = factors(pixels);
    let rows: Vec<&[Color]> = image.rows().collect();
    let estimate_row = |(y, row): (usize, &mut [Pixel])| {
        let [above, below] = [y.saturating_sub(1), (y + 1).min(rows.len() - 1)];
        let around = [above, y, below].map(|y| rows[y]);
        for (x, pixel) in row.iter_mut().enumerate() {
            pixel.error = squared_error(around, x, pixel, &factors);
        }
        row.iter().map(|pixel| pixel.error).sum::<f64>()
    };
    let sums: Vec<f64> = pixels
        .par_chunks_exact_mut(width)
        .enumerate()
        .map(estimate_row)
        .collect();
    sums.iter().sum()
}

fn squared_error(around: [&[Color]; 3], x: usize, pixel: &Pixel, factors: &Factors) -> f64 {
    let n = f64::from(pixel.samples);
    let (bend, shown_bend) = (
        squared_bend(around, x, |c| c),
        squared_bend(around, x, shown),
    );
    if shown_bend == Color::BLACK && pixel.squares == Color::BLACK {
        return 0.0;
    }
    let factor = factors[pixel.samples.ilog2() as usize] / (n * n);
    let variance = pixel.squares * factor;
    let mean = around[1][x].channels();
    // Of twice the deviation either way, what a screen shows: where a pixel is
    // brighter than white, its error may not be seen.
    let seen = |(mean, variance): (f64, f64)| {
        let twice = 2.0 * variance.max(0.0).sqrt();
        let deviation = (shown(mean + twice) - shown(mean - twice)) / 4.0;
        deviation * deviation
    };
    let own: f64 = mean.into_iter().zip(variance.channels()).map(seen).sum();
    // Light five times as bright as white shows five times its share, up to white.
    let lucky = bend.channels().into_iter().zip(shown_bend.channels());
    let lucky: f64 = lucky.map(|(b, shown)| (0.5 * factor * b).min(shown)).sum();
    // With what is no number the passes would never end.
    (own + lucky).max(0.0)
}

/// As a screen shows it.
fn shown(channel: f64) -> f64 {
    channel.clamp(0.0, 1.0)
}

/// How far the pixel is from lying evenly between its neighbours, squared: in
/// the one of the four directions that shows most. An even slope has no bend,
/// for it takes no more than one sample.
fn squared_bend(
    [above, here, below]: [&[Color]; 3],
    x: usize,
    scale: impl Fn(f64) -> f64 + Copy,
) -> Color {
    let (left, right) = (x.saturating_sub(1), (x + 1).min(here.len() - 1));
    let twice = here[x].map(scale) * 2.0;
    let pairs = [
        (here[left], here[right]),
        (above[x], below[x]),
        (above[left], below[right]),
        (above[right], below[left]),
    ];
    let mut greatest = Color::BLACK;
    for (a, b) in pairs {
        let bend = a.map(scale) + b.map(scale) - twice;
        let square = bend * bend;
        greatest = Color::new(
            greatest.r.max(square.r),
            greatest.g.max(square.g),
            greatest.b.max(square.b),
        );
    }
    greatest
}

fn factors(pixels: &[Pixel]) -> Factors {
    let mut sums = [(0.0, 0.0, 0.0); 32];
    for pixel in pixels.iter().filter(|pixel| pixel.samples >= FEW) {
        let n = f64::from(pixel.samples);
        let (count, errors, variances) = &mut sums[pixel.samples.ilog2() as usize];
        let sum = |color: Color| color.channels().iter().sum::<f64>() / (n * n);
        *count += 1.0;
        *errors += sum(pixel.halves * pixel.halves);
        *variances += sum(pixel.squares);
    }
    let mut factors = sums.map(|(count, errors, variances): (f64, f64, f64)| {
        // A few pixels may all be lucky: four are added that are not.
        let few = 4.0 / count;
        ((errors / variances).min(1.0) + few) / (1.0 + few)
    });
    factors
        .iter_mut()
        .filter(|f| !f.is_finite())
        .for_each(|f| *f = 1.0);
    factors[0] = FACTOR_OF_ONE;
    factors
}
