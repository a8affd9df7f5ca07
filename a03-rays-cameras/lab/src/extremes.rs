//! Stiff and extreme cases of cameras and stripes, and of samples: their number, their
//! positions, and their mean.

mod cameras;
mod stripes;

use a02_math::{Point3, Vector3};
use common::{Color, Error, Image, Sampling, Settings, Size};
use measure::Effort;
use measure::extremes::{Absolute, Case, Equal, Fails, Refused, Ulps, case, tried};

use crate::experiments::{RADIUS, disc_coverage, neumaier, sampled};
use crate::protocol;
use a03_rays_cameras::{OrthographicCamera, PixelRandom, Ray, render};

pub fn cases(_: Effort) -> Vec<Case> {
    [cameras::cases(), samples(), stripes::cases()].concat()
}

pub const AHEAD: Vector3 = Vector3::new(0.0, 0.0, -1.0);
pub const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);

/// Found by running the generator backwards from 64 set bits.
const INDEX_OF_THE_GREATEST: u64 = 0x30fd_d71d_1ddc_283c;
const GREATEST_BELOW_1: f64 = 1.0 - f64::EPSILON / 2.0;
const MILLION: u32 = 1_000_000;

/// A picture of `radiance` with an orthographic camera.
fn picture(
    (width, height): (u32, u32),
    sampling: Sampling,
    samples: u32,
    radiance: fn(&Ray) -> Color,
) -> Result<Image, Error> {
    let settings = Settings {
        size: Size::new(width, height)?,
        sampling,
        samples,
        ..Settings::default()
    };
    let camera = OrthographicCamera::new(Point3::ORIGIN, AHEAD, UP, 1.0)?;
    render(&camera, radiance, &settings, &())
}

/// The pixel of a white picture of 1x1 pixels.
fn white(samples: u32) -> f64 {
    let image = picture((1, 1), Sampling::Stratified, samples, |_| Color::WHITE);
    image.map_or(f64::NAN, |image| image.pixels()[0].r)
}

/// Number of pixels of a slope that a regular grid of one sample changes.
fn changed_by_a_grid() -> Result<usize, Error> {
    let slope = |ray: &Ray| Color::gray(ray.origin().x() * 7.0 + ray.origin().y());
    let sloping = |sampling| picture((32, 24), sampling, 1, slope);
    let (middle, regular) = (sloping(Sampling::Center)?, sloping(Sampling::Regular)?);
    let pairs = middle.pixels().iter().zip(regular.pixels());
    Ok(pairs.filter(|(a, b)| a != b).count())
}

#[rustfmt::skip]
fn samples() -> Vec<Case> {
    let in_pixel = |(x, y): &(f64, f64)| (0.0..1.0).contains(x) && (0.0..1.0).contains(y);
    let places = sampled(Sampling::Stratified, 7, 8, 1).filter(in_pixel);
    let greatest = PixelRandom::new(0, 0, 0).uniform(INDEX_OF_THE_GREATEST);
    let plain = tried(|| {
        let image = picture((1, 1), Sampling::Random, MILLION, |_| Color::gray(0.1))?;
        Ok(image.pixels()[0].r)
    });
    let theirs = |samples| protocol::mean_over_grid(samples, 1.0);
    let tenths = (0..MILLION).map(|_| 0.1);
    let pixels = (0..64).flat_map(|y| (0..64).map(move |x| disc_coverage(x.into(), y.into())));
    let bytes = [205, 205, 205, 204];
    let mean = bytes.map(|byte| Color::from_bytes([byte; 3])).into_iter();
    let mean = mean.fold(Color::BLACK, |sum, c| sum + c) * 0.25;
    vec![
        Case::new("Q01", "one stratified sample: places in the pixel", 1.0, Equal, places.count()),
        case("Q02", "a white scene with 2, 3 and 5 samples, divided by the number asked for",
            [white, theirs].map(|mean| [2, 3, 5].map(mean).into()), [1.0; 3], Equal, Fails),
        case("Q03", "a white scene with 0 samples, taken as 1",
            [white, theirs].map(|mean| mean(0).into()), 1.0, Equal, Fails),
        Case::new("Q04", "pixels that a regular grid of one sample changes", 0.0, Equal, changed_by_a_grid()),
        Case::new("Q09", "the greatest random number, 1 - 2^-53, against 32 bits of it",
            GREATEST_BELOW_1, Equal, greatest).protocol(Fails, f64::from(greatest as f32)),
        Case::new("Q10", "a picture of 65536x65536: pixels in 32 bits",
            Refused, Equal, Size::new(65_536, 65_536).map(Size::pixels))
            .protocol(Fails, f64::from(65_536_u32.wrapping_mul(65_536))),
        Case::new("Q07", format!("coverage of 64x64 pixels by a disc of radius {RADIUS}, summed up"),
            1_294.618_916_617_818, Absolute(1e-11), pixels.sum::<f64>()),
        Case::new("Q08", "the mean of a million samples of 0.1, as a pixel sums them",
            0.1, Absolute(f64::from(MILLION) * f64::EPSILON * 0.1), plain),
        Case::new("Q12", "the same by the plain sum, and by Neumaier's",
            0.1, Ulps(1.0), neumaier(tenths) / f64::from(MILLION)).protocol(Fails, plain),
        Case::new("Q13", "the byte of the samples 205, 205, 205 and 204, averaged as whole numbers",
            204.75, Absolute(0.5), f64::from(mean.to_bytes()[0]))
            .protocol(Fails, f64::from(protocol::mean_byte(&bytes))),
    ]
}
