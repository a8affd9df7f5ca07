//! Adaptive sampling: one sample where a pixel needs no more, and many at
//! edges and highlights, until the picture is as exact as it was asked to be.
//!
//! Pass by pass every pixel's error is estimated, and those whose error falls
//! most for a sample get more of them.
//!
//! What no sample and no neighbour shows is not found: an object that lies
//! between the middles of all pixels is missing from the picture.

mod estimate;

use std::f64::consts::FRAC_1_SQRT_2;

use common::{Color, Error, Image, Progress, Sampled, Settings};
use rayon::iter::ParallelIterator;
use rayon::slice::ParallelSliceMut;

use estimate::estimate;

use crate::render::{TOGETHER, for_each_row};
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

/// The least number of samples of a pixel for which one is too few.
const FEW: u32 = 4;

/// A place in the pixel in some column.
pub type Place = (u32, (f64, f64));

/// Renders the rows that are wanted into a black picture of them; `light` comes
/// from some places in a row. Each part of a picture comes to the bound alone, and
/// so the whole does.
pub fn render(
    image: &mut Image,
    max_error: f64,
    settings: &Settings,
    light: impl Fn(u32, &[Place], &mut Vec<Color>) + Sync,
    progress: &dyn Progress,
) -> Result<(), Error> {
    let (size, first_row) = (image.size(), settings.rows().start);
    let width = size.width() as usize;
    let mut pixels = Vec::new();
    let memory = pixels.try_reserve_exact(size.pixels());
    memory.map_err(|_| Error::Memory { size })?;
    pixels.resize(size.pixels(), Pixel::default());

    let paint_middles = |row, colors: &mut [Color], pixels: &mut [Pixel]| {
        let middles: Vec<_> = (0..)
            .map(|column| (column, (0.5, 0.5)))
            .take(width)
            .collect();
        let mut seen = Vec::new();
        for ((colors, pixels), middles) in colors
            .chunks_mut(TOGETHER)
            .zip(pixels.chunks_mut(TOGETHER))
            .zip(middles.chunks(TOGETHER))
        {
            if progress.stopped() {
                return false;
            }
            light(row, middles, &mut seen);
            colors.copy_from_slice(&seen);
            for pixel in pixels {
                pixel.samples = 1;
            }
        }
        true
    };
    let paint_more = |row, colors: &mut [Color], pixels: &mut [Pixel]| {
        let (mut places, mut seen) = (Vec::new(), Vec::new());
        let mut changes = false;
        for (column, (color, pixel)) in (0..).zip(colors.iter_mut().zip(pixels)) {
            if progress.stopped() {
                return false;
            }
            if pixel.wanted > pixel.samples {
                let random = PixelRandom::new(settings.seed, column, row);
                places.clear();
                places.extend(new_places(pixel, random).map(|place| (column, place)));
                light(row, &places, &mut seen);
                add_samples(color, pixel, &seen);
                changes = true;
            }
        }
        changes
    };

    for_each_row(image, first_row, &mut pixels, progress, paint_middles)?;
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
        for_each_row(image, first_row, &mut pixels, progress, paint_more)?;
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

/// Where the samples of a pixel lie that are wanted and not there yet: one of the
/// first half and one of the second in turn.
fn new_places(pixel: &Pixel, random: PixelRandom) -> impl Iterator<Item = (f64, f64)> {
    let sets = [0, 1].map(|set| NestedSamples::new(&random, set));
    // The one in the middle has no half to be in.
    let known = if pixel.samples < FEW {
        0
    } else {
        pixel.samples
    };
    let indices = known / 2..pixel.wanted / 2;
    indices.flat_map(move |index| [sets[0].place(index), sets[1].place(index)])
}

/// Adds what was seen at these places to a pixel. All sums are of differences
/// from the mean so far, so that equal samples have a variance of exactly 0.
fn add_samples(color: &mut Color, pixel: &mut Pixel, seen: &[Color]) {
    let mut sum = Color::BLACK;
    let (pairs, _) = seen.as_chunks();
    for [a, b] in pairs {
        let (a, b) = (*a - *color, *b - *color);
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

/// Chooses how many samples each pixel shall have, so that the errors squared
/// are expected to sum up to what is allowed. Returns how many rows will change.
fn plan(pixels: &mut [Pixel], width: usize, allowed: f64, most: u32) -> u32 {
    let level = level(pixels, allowed);
    let plan_row = |row: &mut [Pixel]| {
        let mut changes = false;
        for pixel in row {
            let now = f64::from(pixel.samples);
            let (mut wanted, mut error) = (now, pixel.error);
            // Not far ahead of what is known: a few samples show little.
            let most = f64::from(most).min((2.0 * now).max(4.0 * now.min(FEW.into())));
            while error / wanted > level {
                let larger = grown(wanted, error);
                if larger.0 > most {
                    break;
                }
                (wanted, error) = larger;
            }
            pixel.wanted = wanted as u32;
            changes |= pixel.wanted > pixel.samples;
        }
        u32::from(changes)
    };
    pixels.par_chunks_exact_mut(width).map(plan_row).sum()
}

/// The next number of samples, and the error that is expected of it: squared,
/// it falls with n^(-3/2) where an edge crosses a pixel (Mitchell, Consequences
/// of Stratified Sampling in Graphics, 1996).
fn grown(samples: f64, error: f64) -> (f64, f64) {
    if samples < f64::from(FEW) {
        (FEW.into(), error / 8.0)
    } else {
        (2.0 * samples, error * FRAC_1_SQRT_2 * 0.5)
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
            let samples = f64::from(pixel.samples);
            large.push((samples, pixel.error));
            level = level.max(pixel.error / samples);
        } else {
            rest += pixel.error;
        }
    }
    let expected = |level: f64| {
        let errors = large.iter().map(|(samples, error)| {
            let (mut samples, mut error) = (*samples, *error);
            while error / samples > level {
                (samples, error) = grown(samples, error);
            }
            error
        });
        errors.sum::<f64>() + rest
    };
    // No picture is so exact that less would be asked for.
    while expected(level) > allowed && level > 1e-30 {
        level *= 0.8;
    }
    level
}
