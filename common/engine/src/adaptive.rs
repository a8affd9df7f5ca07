//! Adaptive sampling: few samples where light changes evenly, and many at edges and
//! highlights, until the error of the picture is below a bound.
//!
//! 1. Each pixel gets pilot samples, more of them if the picture is small: enough to find each
//!    object that is large enough to matter (`pilot`).
//! 2. Where they differ, the expected variance sets a number of samples, and half of them are
//!    taken (`expected_variance`, `allocation`).
//! 3. The other half checks the picture: no decision has seen these samples (`check`). If the
//!    error may be above the bound, 2 and 3 are repeated with a lower target.
//!
//! All samples are part of the picture.
//!
//! (To take more samples where the first differ is Whitted's way, An Improved Illumination
//! Model for Shaded Display, 1980; to estimate errors by two independent halves, the way
//! of Rousselle, Knaus, Zwicker, Adaptive Rendering with Non-Local Means Filtering, 2012.)

mod allocation;
mod check;
mod expected_variance;
mod picture;
mod pilot;
mod pixel;
mod random;
mod sequence;

use common::{Color, Error, Image, Progress, Sampled, Settings};
use rayon::iter::{
    IndexedParallelIterator, IntoParallelRefIterator, IntoParallelRefMutIterator, ParallelIterator,
};

use allocation::{Allocation, Target};
use check::{Checked, Estimate};
use expected_variance::expected_variances;
use picture::Picture;
use pilot::Pilot;
use pixel::Pixel;
pub use random::PixelRandom;

/// Light at positions in a picture, in the coordinates of the camera: whole numbers are the
/// middles of pixels, and y counts upwards.
pub trait Radiance: Sync {
    /// A function that replaces colours by the light at some positions. It is for one thread,
    /// and keeps its memory from one call to the next.
    fn tracer(&self) -> LightAt<'_>;
}

/// Replaces colours by the light at some positions.
pub type LightAt<'a> = Box<dyn FnMut(&[(f64, f64)], &mut Vec<Color>) + 'a>;

impl<F: Fn(f64, f64) -> Color + Sync> Radiance for F {
    fn tracer(&self) -> LightAt<'_> {
        Box::new(|positions, light| {
            light.clear();
            light.extend(positions.iter().map(|(x, y)| self(*x, *y)));
        })
    }
}

/// Channels of a pixel: squared errors are added up over them.
const CHANNELS: f64 = 3.0;
/// Target of the expected squared error, relative to the allowed one without that of objects
/// between all samples. The rest is for errors that the check cannot exclude.
const TARGET: f64 = 0.7;
/// Samples beyond the pilot samples, relative to their number, that the target does not limit:
/// they cost little and make the error smaller.
const SPARE_SAMPLES: f64 = 0.25;
/// Upper bounds of the number of checks, and of refinements before each check.
const CHECKS: u32 = 10;
const REFINEMENTS: u32 = 12;
/// A further refinement has to change more than one pixel of this many.
const PIXELS_PER_REFINED: usize = 300;
/// Upper bound of the factor by which one refinement multiplies the samples of a pixel: a
/// variance from few samples is uncertain.
const GROWTH: u32 = 4;

/// Renders the picture of the light at each position, until its root mean square error is at
/// most `max_error`, with 95 % confidence.
///
/// `progress` gets the estimated error, which may be above `max_error` if that would need more
/// samples of a pixel than the settings allow. Four are always allowed.
///
/// # Errors
///
/// [`Error::Stopped`] if `progress` stops the rendering, [`Error::Memory`] if the picture does
/// not fit into memory.
pub fn render_image(
    max_error: f64,
    radiance: &dyn Radiance,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Image, Error> {
    let mut image = Image::black(settings.size)?;
    let mut picture = Picture::new(radiance, settings, progress)?;
    let max_pairs = (settings.samples / 2).max(2);
    progress.sampled(&converge(&mut picture, max_pairs, max_error)?);

    let colors = picture.pixels().par_iter().map(Pixel::mean);
    let pixels = image.pixels_mut().par_iter_mut().zip(colors);
    pixels.for_each(|(pixel, color)| *pixel = color);
    Ok(image)
}

/// Takes samples until the check shows that the error is at most `max_error`, or a pixel would
/// need more than `max_pairs` pairs.
fn converge(picture: &mut Picture, max_pairs: u32, max_error: f64) -> Result<Sampled, Error> {
    let mut convergence = Convergence::new(picture, max_pairs, max_error);
    for _ in 0..CHECKS {
        let goal = refine(picture, convergence.target())?;
        let checked = check::check(picture, &convergence.pilot, goal);
        picture.check_stopped()?;
        let error = convergence.estimate(&checked, picture.brightest());
        if convergence.has_ended(max_error) {
            break;
        }
        convergence.lower_target(&error, picture.brightest());
    }
    Ok(convergence.sampled(picture))
}

/// The state of sampling between two checks.
struct Convergence {
    pilot: Pilot,
    max_pairs: u32,
    /// The allowed squared error, added up over pixels and channels.
    allowed: f64,
    /// The target of the expected squared error.
    target: f64,
    /// The error that all checks have found in pixels with pilot samples only.
    unrefined: Estimate,
    /// The number of checks, the last ones, without a sample.
    empty_checks: u32,
    sampled: Sampled,
}

impl Convergence {
    /// Takes the first pilot samples.
    fn new(picture: &mut Picture, max_pairs: u32, max_error: f64) -> Self {
        let pixels = picture.pixels().len();
        let allowed = max_error * max_error * CHANNELS * pixels as f64;
        let mut sampled = Sampled {
            pixels: pixels as u64,
            ..Sampled::default()
        };
        let mut pilot = Pilot::new(allowed, max_pairs);
        if pilot.middles {
            picture.take_middles();
            sampled.samples += sampled.pixels;
        } else {
            picture.take(|_, _| pilot.pairs.div_ceil(2));
        }
        pilot.widen(picture.brightest());
        Self {
            target: TARGET * remaining(allowed, pilot.unseen(1.0)),
            pilot,
            max_pairs,
            allowed,
            unrefined: Estimate::default(),
            empty_checks: 0,
            sampled,
        }
    }

    /// The target of the next refinements.
    fn target(&self) -> Target {
        Target {
            min_pairs: self.pilot.pairs,
            max_pairs: self.max_pairs,
            error: self.target,
            spare_samples: SPARE_SAMPLES * self.pilot.samples() * self.sampled.pixels as f64,
        }
    }

    /// The error of the picture after a check, which is recorded in the report.
    fn estimate(&mut self, checked: &Checked, brightest: f64) -> Estimate {
        self.unrefined += checked.unrefined;
        let mut error = checked.known;
        error += self.unrefined;
        self.sampled.audited += checked.pixels;
        self.sampled.squared_error = error.sum / CHANNELS;
        self.sampled.variance = error.variance / (CHANNELS * CHANNELS);
        self.sampled.unseen = self.pilot.unseen(brightest) / CHANNELS;
        self.empty_checks = match checked.pixels {
            0 => self.empty_checks + 1,
            _ => 0,
        };
        error
    }

    /// Whether the error is low enough, or no pixel may have more samples.
    fn has_ended(&self, max_error: f64) -> bool {
        !self.sampled.misses(Some(max_error)) || self.empty_checks == 2
    }

    /// Lowers the target after a check with an error that is too large.
    fn lower_target(&mut self, error: &Estimate, brightest: f64) {
        let left = remaining(self.allowed, self.pilot.unseen(brightest));
        self.target *= (TARGET * left / error.largest()).clamp(0.125, 0.7);
        if self.pilot.widen_after(&self.unrefined, brightest) {
            self.unrefined = Estimate::default();
        }
    }

    /// The report, with the samples of all pixels.
    fn sampled(mut self, picture: &Picture) -> Sampled {
        let pairs = || picture.pixels().par_iter().map(Pixel::pairs);
        self.sampled.samples += pairs().map(|pairs| u64::from(2 * pairs)).sum::<u64>();
        self.sampled.most = 2 * pairs().max().unwrap_or(0);
        self.sampled
    }
}

/// The allowed error without that of objects between all samples, but at least a tenth.
fn remaining(allowed: f64, unseen: f64) -> f64 {
    (allowed - unseen).max(0.1 * allowed)
}

/// Takes half of the samples that the target gives to each pixel with an expected variance. The
/// other half is for the check. Returns the number of pairs that a pixel is to have then, as a
/// function of its index and itself.
fn refine(
    picture: &mut Picture,
    target: Target,
) -> Result<impl Fn(usize, &Pixel) -> u32 + Sync + use<>, Error> {
    let Target {
        min_pairs,
        max_pairs,
        ..
    } = target;
    let (mut refinements, mut own_variances) = (0..REFINEMENTS, Vec::new());
    let (variances, allocation) = loop {
        let variances = expected_variances(picture.pixels(), picture.width(), &mut own_variances);
        let allocation = Allocation::new(&variances, target);
        let half = |i: usize, pixel: &Pixel| {
            let goal = allocation.pairs(variances[i]);
            let half = if goal > min_pairs { goal / 2 } else { 0 };
            half.min(GROWTH * pixel.pairs().max(1))
        };
        let refined = picture.take(half);
        picture.check_stopped()?;
        // The last few pixels are left to the check.
        if refined <= variances.len() / PIXELS_PER_REFINED || refinements.next().is_none() {
            break (variances, allocation);
        }
    };
    Ok(move |i: usize, pixel: &Pixel| {
        let (pairs, mut goal) = (pixel.pairs(), allocation.pairs(variances[i]));
        if pairs >= goal && pairs > pixel.checked_pairs() {
            // It has enough samples, but they are not checked yet.
            goal = 2 * pairs;
        }
        goal.min((2 * pairs).max(min_pairs + 1)).min(max_pairs)
    })
}
