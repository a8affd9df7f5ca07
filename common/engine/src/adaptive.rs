//! Adaptive sampling: few samples where light changes evenly, and many at edges and
//! highlights, until the error of the picture is below a bound.
//!
//! 1. Each pixel gets pilot samples, more of them if the picture is small: enough to find each
//!    object that is large enough to matter (`pilot`). Where only background can be seen, one is
//!    enough (`known_light`).
//! 2. Where samples differ, the expected variance sets a number of samples, and the pixel takes
//!    as many as it has (`expected_variance`, `allocation`).
//! 3. The difference of the new samples from those before estimates the error (`check`). A
//!    target error falls step by step, and 1 to 3 are repeated.
//!
//! The bound only ends this. So a smaller bound takes the same samples, and more. All pairs of
//! samples are part of the picture; a sample in the middle of a pixel is, until there is a pair.
//!
//! (To take more samples where the first differ is Whitted's way, An Improved Illumination
//! Model for Shaded Display, 1980; to estimate errors by two halves, the way of Rousselle,
//! Knaus, Zwicker, Adaptive Rendering with Non-Local Means Filtering, 2012.)

mod allocation;
mod check;
mod expected_variance;
mod known_light;
mod pilot;
mod pixel;
mod random;
mod sampled_picture;
mod sequence;

use common::{Color, Error, Image, Progress, SamplingReport, Settings};
use rayon::iter::{
    IndexedParallelIterator, IntoParallelRefIterator, IntoParallelRefMutIterator, ParallelIterator,
};

use allocation::{Allocation, Target};
use check::{Checked, Estimate, check};
use expected_variance::expected_variances;
pub use known_light::KnownLight;
use pilot::{Pilot, UNSEEN};
use pixel::Pixel;
pub use random::PixelRandom;
use sampled_picture::SampledPicture;

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
/// The error to begin with, and the factor of its square from one target to the next.
const FIRST_ERROR: f64 = 1.0 / 16.0;
const STEP: f64 = 0.7;
/// The least and the largest expected squared error of refined pixels, relative to the one of the
/// step.
const REFINED: [f64; 2] = [0.06, 0.6];
/// Hidden objects are searched for that are as bright as the scene allows, if that is at most this
/// multiple of the brightest light seen, and of white. Brighter ones would cost too many samples in
/// every picture: then nothing is promised.
const BRIGHTER: f64 = 2.0;
/// Samples beyond the pilot samples, relative to their number, that the target does not limit:
/// they cost little and make the error smaller.
const SPARE_SAMPLES: f64 = 0.25;

/// Renders the picture of the light at each position, until its root mean square error is at
/// most `max_error`, with 95 % confidence.
///
/// `progress` gets the estimated error, which may be above `max_error` if that would need more
/// samples of a pixel than the settings allow. Four are always allowed. The sample in the middle
/// of a pixel, with which it may begin, counts as well.
///
/// # Errors
///
/// [`Error::Stopped`] if `progress` stops the rendering, [`Error::Memory`] if the picture does
/// not fit into memory.
pub fn render_image(
    max_error: f64,
    known: &KnownLight,
    radiance: &dyn Radiance,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Image, Error> {
    let mut image = Image::black(settings.size)?;
    let mut picture = SampledPicture::new(radiance, settings, progress)?;
    progress.done(0.0);
    let mut refinement = Refinement::new(&mut picture, known, settings.samples);
    refinement.until(max_error, &mut picture)?;
    progress.sampled(&refinement.sampled(&picture));

    let colors = picture.pixels().par_iter().map(Pixel::mean);
    let pixels = image.pixels_mut().par_iter_mut().zip(colors);
    pixels.for_each(|(pixel, color)| *pixel = color);
    Ok(image)
}

/// The refinement of a picture, target by target.
struct Refinement {
    pilot: Pilot,
    /// The brightest light of any ray.
    max_radiance: f64,
    /// The squared error of the present step, added up over pixels and channels.
    squared_error: f64,
    /// The variances of the samples of each pixel.
    own_variances: Vec<f32>,
    /// The error that all checks have found in pixels with pilot samples only.
    unrefined: Estimate,
    sampled: SamplingReport,
}

impl Refinement {
    /// Takes the first pilot samples.
    fn new(picture: &mut SampledPicture, known: &KnownLight, max_samples: u32) -> Self {
        let max_radiance = known.max_radiance;
        let mut sampled = SamplingReport {
            pixels: picture.pixels().len() as u64,
            max_radiance,
            ..SamplingReport::default()
        };
        let squared_error = sum_of_squares(FIRST_ERROR, &sampled);
        let mut pilot = Pilot::new(squared_error, max_samples);
        sampled.samples = picture.take_middles(pilot.middles, known);
        if !pilot.middles {
            picture.take(pilot.pairs.div_ceil(2));
        }
        let pixels = picture.pixels().par_iter();
        pilot.searched = pixels.filter(|pixel| !pixel.is_background()).count() as f64;
        pilot.widen(brightest_hidden(picture.brightest(), max_radiance));
        Self {
            pilot,
            max_radiance,
            squared_error,
            own_variances: Vec::new(),
            unrefined: Estimate::default(),
            sampled,
        }
    }

    /// Takes samples until the error is at most `max_error`, or every pixel that could gain has as
    /// many as it may have.
    fn until(&mut self, max_error: f64, picture: &mut SampledPicture) -> Result<(), Error> {
        let mut done = 0.0_f64;
        loop {
            let goals = self.goals(picture);
            let checked = check(picture, &self.pilot, self.brightest(picture), goals);
            picture.check_stopped()?;
            self.record(&checked, self.brightest(picture));
            let is_exhausted = checked.pixels == 0 && self.pilot.pairs == self.pilot.max_pairs;
            if is_exhausted || !self.sampled.misses(Some(max_error)) {
                return Ok(());
            }
            // The samples grow about as the reciprocal of the error, and so does the time.
            done = done.max(max_error / self.sampled.max_error());
            picture.progress.done(done);
            self.lower_target(self.brightest(picture));
        }
    }

    /// The brightest light that an object between all samples is assumed to have.
    fn brightest(&self, picture: &SampledPicture) -> f64 {
        brightest_hidden(picture.brightest(), self.max_radiance)
    }

    /// The number of pairs that a pixel is to have after the next check, as a function of its
    /// index and itself: as many again if the target wants more, so that the check compares halves.
    fn goals(&mut self, picture: &SampledPicture) -> impl Fn(usize, &Pixel) -> u32 + Sync + use<> {
        let (pixels, width) = (picture.pixels(), picture.width());
        let variances = expected_variances(pixels, width, &mut self.own_variances);
        let (min_pairs, max_pairs) = (self.pilot.pairs, self.pilot.max_pairs);
        let target = Target {
            min_pairs,
            max_pairs,
            error: self.refined_part(picture) * self.squared_error,
            spare_samples: SPARE_SAMPLES * self.pilot_samples(),
        };
        let allocation = Allocation::new(&variances, target);
        move |i: usize, pixel: &Pixel| {
            if pixel.is_background() {
                return 0;
            }
            let goal = allocation.pairs(variances[i]);
            if goal > pixel.pairs().max(min_pairs) {
                (2 * pixel.pairs()).clamp(min_pairs + 1, max_pairs)
            } else {
                min_pairs
            }
        }
    }

    /// The part of the step's squared error that refined pixels may have.
    ///
    /// The search by `p` pilot samples leaves the squared error `u`, which falls as `p^-2`;
    /// refinement by `r` samples leaves `e`, which falls as `r^-1.5` at edges. The last sample of
    /// each gains equally if `e = 4/3 u r/p`. The check estimates about twice the expected `e`.
    fn refined_part(&self, picture: &SampledPicture) -> f64 {
        let pilot = self.pilot_samples();
        let refined = (self.sampled.samples + picture.samples()) as f64 - pilot;
        let [least, largest] = REFINED;
        (0.5 * 4.0 / 3.0 * UNSEEN * refined / pilot).clamp(least, largest)
    }

    /// The number of pilot samples of all pixels, one where only background is seen.
    fn pilot_samples(&self) -> f64 {
        let background = self.sampled.pixels as f64 - self.pilot.searched;
        self.pilot.samples() * self.pilot.searched + background
    }

    /// Records the error of the picture after a check in the report.
    fn record(&mut self, checked: &Checked, brightest: f64) {
        self.unrefined += checked.unrefined;
        let mut error = checked.known;
        error += self.unrefined;
        self.sampled.squared_error = error.sum / CHANNELS;
        self.sampled.variance = error.variance / (CHANNELS * CHANNELS);
        self.sampled.unseen = self.pilot.unseen(brightest) / CHANNELS;
        self.sampled.brightest = brightest;
    }

    /// Goes on to the next target.
    fn lower_target(&mut self, brightest: f64) {
        self.squared_error *= STEP;
        if self
            .pilot
            .widen_for(self.squared_error, &self.unrefined, brightest)
        {
            self.unrefined = Estimate::default();
        }
    }

    /// The report, with the samples of all pixels.
    fn sampled(mut self, picture: &SampledPicture) -> SamplingReport {
        let pairs = picture.pixels().par_iter().map(Pixel::pairs);
        self.sampled.samples += picture.samples();
        let most = 2 * pairs.max().unwrap_or(0) + u32::from(self.pilot.middles);
        self.sampled.most = most.max(1);
        self.sampled
    }
}

/// The brightest light of hidden objects that are searched for, if `seen` is the brightest light seen,
/// or white, and no hidden object is brighter than `max_radiance`.
fn brightest_hidden(seen: f64, max_radiance: f64) -> f64 {
    if max_radiance <= BRIGHTER * seen {
        max_radiance
    } else {
        seen
    }
}

/// The squared errors of all pixels and channels, for a root mean square error.
fn sum_of_squares(error: f64, sampled: &SamplingReport) -> f64 {
    error * error * CHANNELS * sampled.pixels as f64
}
