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

#[cfg(test)]
mod tests {
    use super::*;

    fn pixel(samples: u32, error: f64) -> Pixel {
        Pixel {
            samples,
            error,
            ..Pixel::default()
        }
    }

    /// Of these values all sums are exact. The first of each pair belongs to the
    /// one half, the second to the other.
    #[test]
    fn samples_are_added_to_mean_squares_and_halves() {
        let values = [
            1.0, 0.0, 0.5, 0.25, 0.0, 1.0, 1.0, 0.75, 0.5, 0.0, 0.25, 0.25, 1.0, 0.5, 1.0, 0.5,
        ];
        let random = PixelRandom::new(1, 2, 3);
        let mut places = Vec::new();
        // The sample in the middle, which 0.25 comes from, does not stay.
        let (mut color, mut pixel) = (Color::gray(0.25), pixel(1, 0.0));
        for (wanted, halves) in [(4, 1.5 - 0.25), (8, 2.5 - 2.0), (16, 5.25 - 3.25)] {
            pixel.wanted = wanted;
            let known = places.len();
            places.extend(new_places(&pixel, random));
            let seen = values[known..places.len()].iter();
            add_samples(
                &mut color,
                &mut pixel,
                &seen.map(|x| Color::gray(*x)).collect::<Vec<_>>(),
            );
            let values = &values[..wanted as usize];
            let mean = values.iter().sum::<f64>() / f64::from(wanted);
            let squares = values.iter().map(|x| (x - mean) * (x - mean)).sum();
            assert_eq!(color, Color::gray(mean));
            assert_eq!(pixel.squares, Color::gray(squares));
            assert_eq!(pixel.halves, Color::gray(halves));
            assert_eq!(pixel.samples, wanted);
        }
        let sets = [0, 1].map(|set| NestedSamples::new(&random, set));
        let expected: Vec<_> = (0..8).flat_map(|i| sets.map(|set| set.place(i))).collect();
        assert_eq!(places, expected);
    }

    /// An eighth of the error by 4 samples instead of 1; then by 2^(-3/2) with
    /// each doubling, which is an eighth for four times as many.
    #[test]
    fn four_times_as_many_samples_leave_an_eighth_of_the_error() {
        assert_eq!(grown(1.0, 2.0), (4.0, 0.25));
        let (twice, error) = grown(4.0, 2.0);
        assert_eq!(twice, 8.0);
        let (four_times, error) = grown(twice, error);
        assert_eq!(four_times, 16.0);
        assert!((error - 0.25).abs() < 4.0 * f64::EPSILON);
    }

    /// The pixels of errors from 0 to 2, some of one sample, some of more.
    fn pixels() -> Vec<Pixel> {
        let samples = [1, 1, 4, 16, 1, 8, 4, 32];
        (0..200_u32)
            .map(|i| {
                let error = 2.0 * f64::from(i * i) / 40_000.0;
                pixel(samples[i as usize % samples.len()], error)
            })
            .collect()
    }

    /// What is left if each pixel comes down to this error for a sample.
    fn left(pixels: &[Pixel], level: f64) -> f64 {
        let come_down = |pixel: &Pixel| {
            let (mut samples, mut error) = (f64::from(pixel.samples), pixel.error);
            while error > level * samples {
                (samples, error) = grown(samples, error);
            }
            error
        };
        pixels.iter().map(come_down).sum()
    }

    /// The level is low enough, and four fifths of a level that is not. A
    /// hundredth of what is allowed may be in pixels that nobody looks at.
    #[test]
    fn the_level_brings_errors_down_to_what_is_allowed_and_little_farther() {
        let pixels = pixels();
        let all = left(&pixels, f64::INFINITY);
        for share in [0.9, 0.5, 0.1, 1e-3, 1e-6] {
            let level = level(&pixels, share * all);
            let allowed = share * all * (1.0 + 1e-12);
            assert!(left(&pixels, level) <= allowed, "{share}");
            assert!(left(&pixels, level / 0.8) > 0.99 * allowed, "{share}");
        }
    }

    #[test]
    fn where_enough_is_known_the_level_is_the_largest_error_of_a_sample() {
        let pixels = [pixel(1, 0.5), pixel(4, 4.0), pixel(16, 8.0)];
        assert_eq!(level(&pixels, 12.5), 1.0);
        assert_eq!(level(&[pixel(4, 0.0)], 0.0), 0.0);
    }

    /// 99 pixels that nobody looks at are together just too much.
    #[test]
    fn what_is_too_small_to_be_looked_at_counts() {
        let mut pixels = vec![pixel(1, 0.009 / 99.0); 100];
        pixels[50].error = 0.995;
        assert_eq!(level(&pixels, 1.0), 0.995 * 0.8);
        pixels[50].error = 0.99;
        assert_eq!(level(&pixels, 1.0), 0.99);
    }

    /// Two rows of two: only where a pixel is above the level does its row
    /// change. From 1 sample on 4 times, then 2 times as many are the most.
    #[test]
    fn a_plan_doubles_the_samples_where_the_error_is_large() {
        let samples = |errors: [f64; 4], now: u32, allowed: f64, most: u32| {
            let mut pixels = errors.map(|error| pixel(now, error));
            let rows = plan(&mut pixels, 2, allowed, most);
            (rows, pixels.map(|pixel| pixel.wanted))
        };
        let errors = [1.0, 0.0, 0.0, 0.0];
        assert_eq!(samples(errors, 4, 1.0, 99), (0, [4; 4]));
        assert_eq!(samples(errors, 4, 0.5, 99), (1, [8, 4, 4, 4]));
        assert_eq!(samples(errors, 4, 0.2, 99), (1, [16, 4, 4, 4]));
        assert_eq!(
            samples(errors, 4, 1e-9, 99),
            (1, [16, 4, 4, 4]),
            "no farther"
        );
        assert_eq!(samples(errors, 32, 1e-9, 99), (1, [64, 32, 32, 32]));
        assert_eq!(samples(errors, 32, 1e-9, 63), (0, [32; 4]));
        assert_eq!(samples(errors, 1, 0.5, 99), (1, [4, 1, 1, 1]));
        assert_eq!(samples(errors, 1, 0.5, 3), (0, [1; 4]));
        assert_eq!(samples([1.0, 0.0, 0.0, 1.0], 4, 1.0, 99), (2, [8, 4, 4, 8]));
    }
}
