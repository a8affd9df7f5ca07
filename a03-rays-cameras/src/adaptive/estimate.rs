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

#[cfg(test)]
mod tests {
    use common::Size;

    use super::*;

    fn pixel(samples: u32, squares: f64, halves: f64) -> Pixel {
        Pixel {
            samples,
            squares: Color::gray(squares),
            halves: Color::gray(halves),
            ..Pixel::default()
        }
    }

    /// Three rows of grey.
    fn around(rows: [[f64; 3]; 3]) -> [[Color; 3]; 3] {
        rows.map(|row| row.map(Color::gray))
    }

    /// The error squared of the pixel in the middle, in one channel.
    fn error(rows: [[f64; 3]; 3], pixel: &Pixel, factor: f64) -> f64 {
        let rows = around(rows);
        squared_error([&rows[0], &rows[1], &rows[2]], 1, pixel, &[factor; 32]) / 3.0
    }

    /// Squares of 0.5 in 4 samples are a variance of 0.5 / 4² of their mean; half
    /// of it counts, 0.125².
    #[test]
    fn samples_that_differ_are_off_by_their_share_of_the_variance() {
        let differing = pixel(4, 0.5, 0.0);
        assert_eq!(error([[0.5; 3]; 3], &differing, 0.5), 0.015_625);
        // Half of it is brighter than white, or all.
        assert_eq!(error([[1.0; 3]; 3], &differing, 0.5), 0.015_625 / 4.0);
        assert_eq!(error([[2.0; 3]; 3], &differing, 0.5), 0.0);
    }

    /// The neighbours are 0.25 brighter on both sides: together 0.5, of whose
    /// square half a sample is one part in 2 · 4², and half of that counts.
    #[test]
    fn neighbours_add_the_light_of_half_a_sample() {
        let alike = pixel(4, 0.0, 0.0);
        let (low, high) = (0.25, 0.5);
        for rows in [
            [[low; 3], [high, low, high], [low; 3]],
            [[low, high, low], [low; 3], [low, high, low]],
            [[high, low, low], [low; 3], [low, low, high]],
            [[low, low, high], [low; 3], [high, low, low]],
        ] {
            assert_eq!(error(rows, &alike, 0.5), 0.25 * 0.5 / 16.0 * 0.5);
        }
        let slope = [[0.0, 0.25, 0.5], [0.25, 0.5, 0.75], [0.5, 0.75, 1.0]];
        assert_eq!(error(slope, &alike, 0.5), 0.0, "an even slope");
        let glaring = [[10.0, 0.0, 10.0]; 3];
        assert_eq!(
            error(glaring, &pixel(1, 0.0, 0.0), 1.0),
            4.0,
            "no more than white"
        );
        assert_eq!(
            error([[f64::NAN; 3]; 3], &pixel(4, 0.5, 0.0), 0.5),
            0.0,
            "no number"
        );
    }

    /// One white pixel: all of its eight neighbours see it, at the border, too,
    /// where they are their own neighbours. Of one sample each 0.25 / 2 counts, of
    /// the square of 1 for the neighbours and of 2 for itself, in three channels.
    #[test]
    fn a_lone_pixel_is_seen_by_all_around_it() {
        let size = Size::new(5, 5).unwrap();
        for (x, y) in [(2, 2), (1, 1), (3, 3), (1, 3), (3, 1)] {
            let mut image = Image::black(size).unwrap();
            image.set(x, y, Color::WHITE);
            let mut pixels = vec![pixel(1, 0.0, 0.0); 25];
            let sum = estimate(&image, &mut pixels);
            for (i, pixel) in (0..).zip(&pixels) {
                let expected = match (x.abs_diff(i % 5), y.abs_diff(i / 5)) {
                    (0, 0) => 1.5,
                    (0..=1, 0..=1) => 0.375,
                    _ => 0.0,
                };
                assert_eq!(pixel.error, expected, "{x}, {y}: {i}");
            }
            assert_eq!(sum, 1.5 + 8.0 * 0.375);
        }
    }

    /// Four pixels of 4 samples, whose squared half differences are a quarter of
    /// their squares; four more that are taken for unlucky make it 5/8.
    #[test]
    fn the_factor_is_what_the_halves_show_of_the_variance() {
        let mut pixels = vec![pixel(1, 9.0, 9.0); 3];
        assert_eq!(factors(&pixels)[2], 1.0, "of nothing");
        pixels.extend([pixel(4, 1.0, 0.5); 4]);
        pixels.push(pixel(8, 1.0, 2.0));
        let found = factors(&pixels);
        assert_eq!(found[0], FACTOR_OF_ONE);
        assert_eq!((found[1], found[2], found[3]), (1.0, 0.625, 1.0));
        // 2 of 4 and 2 of 6 samples: (1/16 + 4/36) / (4/16 + 8/36) = 25/68.
        let pixels = [pixel(4, 4.0, 1.0), pixel(6, 8.0, 2.0)];
        let expected = (25.0 / 68.0 + 2.0) / 3.0;
        assert!((factors(&pixels)[2] - expected).abs() < 4.0 * f64::EPSILON);
    }
}
