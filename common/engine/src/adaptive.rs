//! Adaptive sampling: few samples where light changes evenly, and many at edges and
//! highlights, until the picture is as exact as it was asked to be.
//!
//! 1. Each pixel gets a few samples, more if the picture is small: enough that an object
//!    so large that it matters is met (`search`).
//! 2. Where samples differ, a goal is set for the number of samples (`doubt`, `allocation`),
//!    and half of them are taken.
//! 3. The other half checks the picture: no decision has seen these samples (`check`). If the
//!    picture may be farther off than allowed, 2 and 3 are repeated with a lower aim.
//!
//! All samples are part of the picture.
//!
//! (To take more samples where the first differ is Whitted's way, An Improved Illumination
//! Model for Shaded Display, 1980; to estimate errors by two independent halves, the way
//! of Rousselle, Knaus, Zwicker, Adaptive Rendering with Non-Local Means Filtering, 2012.)

mod allocation;
mod check;
mod doubt;
mod picture;
mod pixel;
pub(crate) mod random;
mod search;
mod sequence;

use common::{Color, Error, Image, Progress, Sampled, Settings};
use rayon::iter::{
    IndexedParallelIterator, IntoParallelRefIterator, IntoParallelRefMutIterator, ParallelIterator,
};

use allocation::{Allocation, Wish};
use check::Estimate;
use picture::Picture;
use pixel::Pixel;
use search::Search;

/// Light at places of a picture, in the coordinates of the camera: whole numbers are the
/// middles of pixels, and y counts upwards.
pub trait Radiance: Sync {
    /// Memory that one call after the other uses.
    type Memory: Default;

    /// The light at some places.
    fn light<'m>(&self, places: &[(f64, f64)], memory: &'m mut Self::Memory) -> &'m [Color];
}

impl<F: Fn(f64, f64) -> Color + Sync> Radiance for F {
    type Memory = Vec<Color>;

    fn light<'m>(&self, places: &[(f64, f64)], light: &'m mut Vec<Color>) -> &'m [Color] {
        light.clear();
        light.extend(places.iter().map(|(x, y)| self(*x, *y)));
        light
    }
}

/// Channels of a pixel: squared errors are added up over them.
const CHANNELS: f64 = 3.0;
/// The share of the allowed squared error that the expected one aims at, beside objects that
/// no sample met. The rest is for errors that the check cannot exclude.
const AIM: f64 = 0.7;
/// Samples of doubted pixels, for each sample that every pixel needs: for little, they make
/// the picture more exact than it has to be.
const FREE: f64 = 0.25;
/// The most often that a picture is checked, and refined before each check.
const ROUNDS: u32 = 10;
const STEPS: u32 = 12;
/// Another step is not worth its time for fewer than one pixel of this many.
const FEW: usize = 300;
/// The first samples tell too little to take more than this many times as many.
const GROWTH: u32 = 4;

/// Renders the picture of the light at each place, until its root mean square error is at
/// most `max_error`, with 95 % confidence.
///
/// `progress` is told how far off the picture is, which may be more than `max_error` if that
/// would need more samples of a pixel than the settings allow. Four are always allowed.
///
/// # Errors
///
/// [`Error::Stopped`] if `progress` stops the rendering, [`Error::Memory`] if the picture does
/// not fit into memory.
pub fn render_image(
    max_error: f64,
    radiance: &impl Radiance,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Image, Error> {
    let mut image = Image::black(settings.size)?;
    let mut picture = Picture::new(radiance, settings, progress)?;
    let most = (settings.samples / 2).max(2);
    progress.sampled(&converge(&mut picture, most, max_error)?);

    let colors = picture.pixels().par_iter().map(Pixel::mean);
    let pixels = image.pixels_mut().par_iter_mut().zip(colors);
    pixels.for_each(|(pixel, color)| *pixel = color);
    Ok(image)
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
    let mut sampled = Sampled {
        pixels: pixels as u64,
        ..Sampled::default()
    };
    let mut search = Search::new(allowed, most);
    if search.middles {
        picture.take_middles();
        sampled.samples += sampled.pixels;
    } else {
        picture.take(|_, _| search.pairs.div_ceil(2));
    }
    search.widen(picture.brightest());

    let mut aim = AIM * (allowed - search.unseen(1.0)).max(0.1 * allowed);
    let (mut unknown, mut idle) = (Estimate::default(), 0);
    for _ in 0..ROUNDS {
        let wish = Wish {
            least: search.pairs,
            most,
            aim,
            free: FREE * search.samples() * pixels as f64,
        };
        let goal = refine(picture, wish)?;
        let found = check::check(picture, &search, goal);
        picture.check_stopped()?;

        unknown += found.unknown;
        let mut error = found.known;
        error += unknown;
        let brightest = picture.brightest();
        let unseen = search.unseen(brightest);
        sampled.audited += found.checked;
        sampled.squared_error = error.sum / CHANNELS;
        sampled.variance = error.variance / (CHANNELS * CHANNELS);
        sampled.unseen = unseen / CHANNELS;
        idle = if found.checked > 0 { 0 } else { idle + 1 };
        if !sampled.misses(Some(max_error)) || idle == 2 {
            break;
        }
        let left = (allowed - unseen).max(0.1 * allowed);
        aim *= (AIM * left / error.largest()).clamp(0.125, 0.7);
        if search.widen_after(&unknown, brightest) {
            unknown = Estimate::default();
        }
    }
    let pairs = || picture.pixels().par_iter().map(Pixel::pairs);
    sampled.samples += pairs().map(|pairs| u64::from(2 * pairs)).sum::<u64>();
    sampled.most = 2 * pairs().max().unwrap_or(0);
    Ok(sampled)
}

/// Takes half of the samples that the wish gives to each doubted pixel. The other half is
/// for the check. Returns the number of pairs that a pixel is to have then, as a function of
/// its index and itself.
fn refine<R: Radiance>(
    picture: &mut Picture<R>,
    wish: Wish,
) -> Result<impl Fn(usize, &Pixel) -> u32 + Sync + use<R>, Error> {
    let Wish { least, most, .. } = wish;
    let (mut steps, mut spreads) = (0..STEPS, Vec::new());
    let (doubts, allocation) = loop {
        let doubts = doubt::doubts(picture.pixels(), picture.width(), &mut spreads);
        let allocation = Allocation::new(&doubts, wish);
        let half = |i: usize, pixel: &Pixel| {
            let goal = allocation.pairs(doubts[i]);
            let half = if goal > least { goal / 2 } else { 0 };
            half.min(GROWTH * pixel.pairs().max(1))
        };
        let taken = picture.take(half);
        picture.check_stopped()?;
        // A few more pixels are left to the check.
        if taken <= doubts.len() / FEW || steps.next().is_none() {
            break (doubts, allocation);
        }
    };
    Ok(move |i: usize, pixel: &Pixel| {
        let (pairs, mut goal) = (pixel.pairs(), allocation.pairs(doubts[i]));
        if pairs >= goal && pairs > pixel.checked() {
            // It has more samples by now than it needs, but they are not checked yet.
            goal = 2 * pairs;
        }
        goal.min((2 * pairs).max(least + 1)).min(most)
    })
}
