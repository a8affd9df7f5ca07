//! Adaptive sampling: few samples where light changes evenly, and many at edges and
//! highlights, until the picture is as exact as it was asked to be.
//!
//! 1. Each pixel gets a few samples, more if the picture is small: enough that an object
//!    so large that it matters is met.
//! 2. Where samples differ, more are taken (`doubt`, `allocation`).
//! 3. New samples check the picture (`check`): all pixels that looked even, and some of the
//!    others. If it may be farther off than allowed, 2 and 3 are repeated with a lower aim.
//!
//! (To take more samples where the first differ is Whitted's way, An Improved Illumination
//! Model for Shaded Display, 1980; to estimate errors by two independent halves that of
//! Rousselle, Knaus, Zwicker, Adaptive Rendering with Non-Local Means Filtering, 2012.)

mod allocation;
mod check;
mod doubt;
mod picture;
mod pixel;
pub(crate) mod random;
mod sequence;

use std::ops::RangeInclusive;

use common::{Color, Error, Image, Progress, Sampled, Settings};
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::{ParallelSlice, ParallelSliceMut};

use crate::image_of_rows;
use allocation::Allocation;
use check::Estimate;
use picture::Picture;
use pixel::Pixel;

/// Light at places of a picture, in the coordinates of the camera: whole numbers are the
/// middles of pixels, and y counts upwards.
pub trait Radiance: Sync {
    /// The light at some places.
    fn light(&self, places: &[(f64, f64)], light: &mut Vec<Color>);
}

/// Light of one place after the other, from a function.
struct OneByOne<F>(F);

impl<F: Fn(f64, f64) -> Color + Sync> Radiance for OneByOne<F> {
    fn light(&self, places: &[(f64, f64)], light: &mut Vec<Color>) {
        light.clear();
        light.extend(places.iter().map(|(x, y)| (self.0)(*x, *y)));
    }
}

/// Renders the picture, or the rows of it that the settings select, of the light at each
/// place, until its root mean square error is at most `max_error`, with 95 % confidence.
///
/// `progress` is told how far off the picture is, which may be more than `max_error` if that
/// would need more samples of a pixel than the settings allow. At least four are taken.
///
/// # Errors
///
/// [`Error::Stopped`] if `progress` stops the rendering, [`Error::Memory`] if the picture does
/// not fit into memory.
pub fn render_image(
    max_error: f64,
    light: impl Fn(f64, f64) -> Color + Sync,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Image, Error> {
    let light = OneByOne(light);
    image_of_rows(settings, |pixels, copy| {
        render(max_error, settings, &light, progress, pixels, copy)
    })
}

/// Channels of a pixel: squared errors are added up over them.
const CHANNELS: f64 = 3.0;
/// The rule of three: of events of which none was seen, at most three were to be expected,
/// with 95 % confidence.
const UNSEEN: f64 = 3.0;
/// The share of the allowed squared error that the expected one aims at. The rest is for what
/// the check cannot exclude.
const AIM: f64 = 0.4;
/// The most often that a picture is checked, and refined before each check.
const ROUNDS: u32 = 10;
const STEPS: u32 = 12;
/// The first samples tell too little to take more than this many times as many.
const GROWTH: u32 = 4;

/// Like [`render_image`], but hands each finished row to `keep`, with its share of
/// `kept`, instead of building an image. Each part of a picture comes to the bound alone,
/// and so the whole does.
pub fn render<T: Send>(
    max_error: f64,
    settings: &Settings,
    radiance: &impl Radiance,
    progress: &dyn Progress,
    kept: &mut [T],
    keep: impl Fn(&[Color], &mut [T]) + Sync,
) -> Result<(), Error> {
    let mut picture = Picture::new(radiance, settings, progress)?;
    let most = (settings.samples / 2).max(2);
    progress.sampled(&converge(&mut picture, most, max_error)?);

    let rows = picture.pixels().par_chunks_exact(picture.width());
    let kept = kept.par_chunks_exact_mut(kept.len() / settings.rows().len());
    rows.zip(kept).for_each(|(pixels, kept)| {
        let colors: Vec<_> = pixels.iter().map(Pixel::mean).collect();
        keep(&colors, kept);
    });
    Ok(())
}

/// Takes samples until the check shows that the error is at most `max_error`, or a pixel would
/// need more than `most` pairs.
fn converge<R: Radiance>(
    picture: &mut Picture<R>,
    most: u32,
    max_error: f64,
) -> Result<Sampled, Error> {
    let pixels = picture.pixels().len();
    let allowed = max_error * max_error * CHANNELS * pixels as f64;
    let mut base = first_pairs(allowed).min(most / 2);
    picture.take(|_| base);

    let (mut aim, mut even, mut idle) = (AIM * allowed, None, 0);
    let mut sampled = Sampled {
        pixels: pixels as u64,
        ..Sampled::default()
    };
    for round in 1..=ROUNDS {
        let least = if even.is_some() { base } else { 2 * base };
        let (any, of_few) = refine(picture, base..=least, most, aim)?;
        let of_even = even.unwrap_or_else(|| check::double(picture, base));
        idle = if any || base < least { 0 } else { idle + 1 };
        base = least;
        let (of_edges, samples) = audit(picture, base, round);
        picture.check_stopped()?;

        let mut error = of_even;
        error += of_edges;
        let unseen = unseen(base, picture) + (of_few - error.sum).max(0.0);
        sampled.samples += samples;
        sampled.audited += error.pixels;
        sampled.squared_error = error.sum / CHANNELS;
        sampled.variance = error.variance / (CHANNELS * CHANNELS);
        sampled.unseen = unseen / CHANNELS;
        if !sampled.misses(Some(max_error)) || idle == 2 {
            break;
        }
        // Pixels that looked even are checked again only if much of the error may be theirs.
        let is_small = of_even.sum + 2.0 * of_even.variance.sqrt() + unseen < 0.6 * allowed;
        even = (is_small || 2 * base >= most).then_some(of_even);
        let slowest = if idle > 0 { 0.25 } else { 0.7 };
        aim *= (AIM * allowed / error.sum.max(0.0)).clamp(0.125, slowest);
    }
    let pairs = || picture.pixels().iter().map(Pixel::pairs);
    sampled.samples += pairs().map(|pairs| u64::from(2 * pairs)).sum::<u64>();
    sampled.most = 2 * pairs().max().unwrap_or(0);
    Ok(sampled)
}

/// The pairs that each pixel begins with: a quarter of the samples with which [`unseen`] is a
/// third of what is allowed in a picture without glare, because the check doubles their number.
fn first_pairs(allowed: f64) -> u32 {
    let samples = (3.0 * CHANNELS * UNSEEN / allowed).sqrt();
    (samples / 4.0).ceil().max(1.0) as u32
}

/// The squared error of objects that no sample met, with 95 % confidence: three pixels in
/// which one more sample might have been off by as much as the brightest pixel is, but at
/// least by 1, and the mean by its `n`-th part.
fn unseen<R: Radiance>(pairs: u32, picture: &Picture<R>) -> f64 {
    let channels = picture.pixels().iter().map(|pixel| pixel.mean().channels());
    let brightest = channels
        .flatten()
        .filter(|c| c.is_finite())
        .fold(1.0, f64::max);
    let off = brightest / f64::from(2 * pairs);
    CHANNELS * UNSEEN * off * off
}

/// Takes more samples of doubted pixels, until the expected squared errors add up to `aim`.
/// Pixels with `bases.start()` pairs look even; the check will leave them with `bases.end()`,
/// and all others have more. Returns whether samples were taken, and the expected squared
/// errors of a few pixels.
fn refine<R: Radiance>(
    picture: &mut Picture<R>,
    bases: RangeInclusive<u32>,
    most: u32,
    aim: f64,
) -> Result<(bool, f64), Error> {
    let (base, least) = bases.into_inner();
    let (mut any, mut of_few) = (false, 0.0);
    for _ in 0..STEPS {
        let doubts = doubt::doubts(picture.pixels(), picture.width());
        let allocation = Allocation::new(&doubts, least, most, aim);
        of_few = allocation.of_few();
        let more = |(pixel, doubt): (&Pixel, &f32)| {
            let (pairs, wanted) = (pixel.pairs(), allocation.pairs(*doubt));
            if wanted > least && wanted > pairs {
                wanted.min(GROWTH * pairs)
            } else if pairs > base && pairs <= least {
                (2 * least).min(most)
            } else {
                0
            }
        };
        let wanted: Vec<_> = picture.pixels().iter().zip(&doubts).map(more).collect();
        if wanted.iter().all(|pairs| *pairs == 0) {
            break;
        }
        any = true;
        picture.take(|i| wanted[i]);
        picture.check_stopped()?;
    }
    Ok((any, of_few))
}

/// Checks so many of the pixels with more than `base` pairs that it takes an eighth of the
/// picture's samples, or 256 pixels. Returns the number of samples as well.
fn audit<R: Radiance>(picture: &Picture<R>, base: u32, round: u32) -> (Estimate, u64) {
    let pairs = || picture.pixels().iter().map(|p| u64::from(p.pairs()));
    let of_edges = || pairs().filter(|pairs| *pairs > base.into());
    let share = pairs().sum::<u64>() as f64 / 8.0 / of_edges().sum::<u64>() as f64;
    let probability = share.max(256.0 / of_edges().count() as f64).min(1.0);
    check::audit(picture, base, probability, round)
}
