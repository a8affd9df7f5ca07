//! Adaptive sampling: one sample where a pixel needs no more, and many at
//! edges and highlights, until the picture is as exact as it was asked to be.
//!
//! Pass by pass every pixel's error is estimated, and those whose error falls
//! most for a sample get more of them. The estimate rests on three things:
//!
//! - Samples that differ. The plain variance of their mean, σ²/n, is too large
//!   for evenly spread samples.
//! - Two halves of the samples, spread independently of each other. A quarter
//!   of the squared difference of their means is the error squared, on average
//!   over many pixels; what it is of σ²/n over all pixels of n samples is the
//!   factor for each of them.
//! - Neighbours. Samples that agree may do so by luck, so half a sample of the
//!   neighbours' light is added to them.
//!
//! What no sample and no neighbour shows is not found: an object that lies
//! between the middles of all pixels is missing from the picture.

use common::{Color, Error, Image, Progress, Sampled, Settings};
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;

use crate::render::for_each_pixel;
use crate::{NestedSamples, PixelRandom};

/// What the samples of a pixel have shown, besides their mean.
#[derive(Clone, Copy, Debug, Default)]
struct Pixel {
    /// How many there are; a single one lies in the middle.
    samples: u32,
    /// How many there shall be after the next pass.
    wanted: u32,
    /// The sum of their squared distances from the mean.
    squares: Color,
    /// The sum of the first half of them less that of the second.
    halves: Color,
    /// The estimated square of the error, summed over the channels.
    error: f64,
}

/// The share of σ²/n, for each binary logarithm of the number of samples,
/// that is the squared error of the mean.
type Factors = [f64; 32];

/// A sample in the middle of a pixel that a straight edge of height h crosses is
/// off by at most h/2. Two pixels see the edge, and of its square the estimate
/// takes half.
const FACTOR_OF_ONE: f64 = 0.25;

/// The least number of samples of a pixel for which one is too few.
const FEW: u32 = 4;

/// Renders into a black picture; `light` comes from a place of the pixel in
/// some column and row.
pub fn render(
    image: &mut Image,
    max_error: f64,
    settings: &Settings,
    light: impl Fn(u32, u32, (f64, f64)) -> Color + Sync,
    progress: &dyn Progress,
) -> Result<(), Error> {
    let size = image.size();
    let width = size.width() as usize;
    let mut pixels = Vec::new();
    let memory = pixels.try_reserve_exact(size.pixels());
    memory.map_err(|_| Error::Memory { size })?;
    pixels.resize(size.pixels(), Pixel::default());

    for_each_pixel(image, &mut pixels, progress, |column, row, color, pixel| {
        *color = light(column, row, (0.5, 0.5));
        pixel.samples = 1;
        true
    })?;
    // Summed over pixels and channels.
    let allowed = max_error * max_error * 3.0 * size.pixels() as f64;
    let error = loop {
        let error = estimate(image, &mut pixels);
        if error <= allowed {
            break error;
        }
        let rows = plan(&mut pixels, width, allowed, settings.samples);
        if rows == 0 {
            break error;
        }
        progress.more_rows(rows);
        for_each_pixel(image, &mut pixels, progress, |column, row, color, pixel| {
            let grows = pixel.wanted > pixel.samples;
            if grows {
                let random = PixelRandom::new(settings.seed, column, row);
                add_samples(color, pixel, random, |place| light(column, row, place));
            }
            grows
        })?;
    };

    // The sample in the middle was taken of every pixel.
    let more = |n: u32| if n == 1 { 0 } else { u64::from(n) };
    progress.sampled(&Sampled {
        pixels: size.pixels() as u64,
        samples: size.pixels() as u64 + pixels.iter().map(|p| more(p.samples)).sum::<u64>(),
        most: pixels.iter().map(|p| p.samples).max().unwrap_or(0),
        squared_error: error / 3.0,
    });
    Ok(())
}

/// Takes the samples of a pixel that are wanted and not there yet. All sums
/// are of differences from the mean so far, so that equal samples have a
/// variance of exactly 0.
fn add_samples(
    color: &mut Color,
    pixel: &mut Pixel,
    random: PixelRandom,
    light: impl Fn((f64, f64)) -> Color,
) {
    let sets = [0, 1].map(|set| NestedSamples::new(&random, set));
    // The one in the middle has no half to be in.
    let known = if pixel.samples < FEW {
        0
    } else {
        pixel.samples
    };
    let mut sum = Color::BLACK;
    for index in known / 2..pixel.wanted / 2 {
        let [a, b] = sets.map(|set| light(set.place(index)) - *color);
        sum += a + b;
        pixel.squares += a * a + b * b;
        pixel.halves += a - b;
    }
    let n = f64::from(pixel.wanted);
    let step = sum.map(|channel| channel / n);
    pixel.squares = pixel.squares - step * step * n;
    *color += step;
    pixel.samples = pixel.wanted;
}

/// Estimates the error of every pixel, and returns the sum of their squares.
fn estimate(image: &Image, pixels: &mut [Pixel]) -> f64 {
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

/// Chooses how many samples each pixel shall have, so that the errors squared
/// are expected to sum up to what is allowed. Returns how many rows will change.
fn plan(pixels: &mut [Pixel], width: usize, allowed: f64, most: u32) -> u32 {
    let level = level(pixels, allowed);
    let plan_row = |row: &mut [Pixel]| {
        let mut changes = false;
        for pixel in row {
            let (mut wanted, mut error) = (pixel.samples, pixel.error);
            // Not far ahead of what is known: a few samples show little.
            let next = (2 * pixel.samples).max(4 * FEW.min(pixel.samples));
            while error / f64::from(wanted) > level && wanted < next {
                (wanted, error) = grown(wanted, error);
            }
            pixel.wanted = if wanted > most { pixel.samples } else { wanted };
            changes |= pixel.wanted > pixel.samples;
        }
        u32::from(changes)
    };
    pixels.par_chunks_exact_mut(width).map(plan_row).sum()
}

/// The next number of samples, and the error that is expected of it: squared,
/// it falls with n^(-3/2) where an edge crosses a pixel (Mitchell, Consequences
/// of Stratified Sampling in Graphics, 1996).
fn grown(samples: u32, error: f64) -> (u32, f64) {
    if samples < FEW {
        (FEW, error / 8.0)
    } else {
        (2 * samples, error * std::f64::consts::FRAC_1_SQRT_2 * 0.5)
    }
}

/// The error squared per sample that all pixels must come down to.
fn level(pixels: &[Pixel], allowed: f64) -> f64 {
    // What is far too small to matter need not be looked at again and again.
    let small = 0.01 * allowed / pixels.len() as f64;
    let (mut rest, mut level) = (0.0, 0.0_f64);
    let mut large = Vec::new();
    for pixel in pixels {
        if pixel.error > small {
            large.push((pixel.samples, pixel.error));
            level = level.max(pixel.error / f64::from(pixel.samples));
        } else {
            rest += pixel.error;
        }
    }
    let expected = |level: f64| {
        let errors = large.iter().map(|(samples, error)| {
            let (mut samples, mut error) = (*samples, *error);
            while error / f64::from(samples) > level {
                (samples, error) = grown(samples, error);
            }
            error
        });
        errors.sum::<f64>() + rest
    };
    while expected(level) > allowed {
        level *= 0.8;
    }
    level
}
