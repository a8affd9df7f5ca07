//! Stiff and extreme cases of cameras and stripes, and of samples: their number, their
//! positions, and their mean.

mod cameras;
mod stripes;

use a02_math::{Point3, Vector3};
use common::{Color, Error, Image, Sampling, Settings, Size};
use measure::Effort;
use measure::extremes::{
    Absolute, Case, Fails, Known, Number, Refused, Triple, Ulps, Without, tried,
};

use crate::experiments::{RADIUS, disc_coverage, sampled};
use crate::neumaier::neumaier;
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

/// A picture with an orthographic camera.
fn picture(
    [width, height]: [u32; 2],
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

/// The only pixel of a picture that is gray everywhere.
fn pixel(sampling: Sampling, samples: u32, radiance: fn(&Ray) -> Color) -> Result<f64, Error> {
    let image = picture([1, 1], sampling, samples, radiance)?;
    Ok(image.pixels()[0].r)
}

fn white(samples: u32) -> f64 {
    pixel(Sampling::Stratified, samples, |_| Color::WHITE).unwrap_or(f64::NAN)
}

fn protocols_white(samples: u32) -> f64 {
    protocol::mean_over_grid(samples, 1.0)
}

/// The number of positions inside the pixel, for one stratified sample.
fn places_in_the_pixel() -> usize {
    let places = sampled(Sampling::Stratified, 7, 8, 1);
    let inside = 0.0..1.0;
    places
        .filter(|(x, y)| inside.contains(x) && inside.contains(y))
        .count()
}

/// Number of pixels of a slope that a regular grid of one sample changes.
fn changed_by_a_grid() -> Result<usize, Error> {
    let slope = |ray: &Ray| Color::gray(ray.origin().x() * 7.0 + ray.origin().y());
    let middle = picture([32, 24], Sampling::Center, 1, slope)?;
    let regular = picture([32, 24], Sampling::Regular, 1, slope)?;
    let mut changed = 0;
    for (a, b) in middle.pixels().iter().zip(regular.pixels()) {
        changed += usize::from(a != b);
    }
    Ok(changed)
}

/// The area of the disc, summed up from the coverage of pixels.
fn area_of_the_disc() -> f64 {
    let mut area = 0.0;
    for y in 0..64 {
        for x in 0..64 {
            area += disc_coverage(x.into(), y.into());
        }
    }
    area
}

/// The byte of the mean of four gray samples, summed as linear colours.
fn byte_of_mean(bytes: [u8; 4]) -> u8 {
    let mut sum = Color::BLACK;
    for byte in bytes {
        sum += Color::from_bytes([byte; 3]);
    }
    (sum * 0.25).to_bytes()[0]
}

fn samples() -> Vec<Case> {
    let greatest = PixelRandom::new(0, 0, 0).uniform(INDEX_OF_THE_GREATEST);
    let plain = tried(|| pixel(Sampling::Random, MILLION, |_| Color::gray(0.1)));
    let tenths = (0..MILLION).map(|_| 0.1);
    let bytes = [205, 205, 205, 204];
    vec![
        Case {
            id: "Q01".into(),
            what: "one stratified sample: places in the pixel".into(),
            exact: Number(1.0),
            condition: Without("a count".into()),
            ours: places_in_the_pixel().into(),
            ..Case::default()
        },
        Case {
            id: "Q02".into(),
            what: "a white scene with 2, 3 and 5 samples, divided by the number asked for".into(),
            exact: Triple([1.0; 3]),
            condition: Known(1.0),
            protocol: Fails,
            ..Case::of([2, 3, 5].map(white), [2, 3, 5].map(protocols_white))
        },
        Case {
            id: "Q03".into(),
            what: "a white scene with 0 samples, taken as 1".into(),
            exact: Number(1.0),
            condition: Known(1.0),
            protocol: Fails,
            ..Case::of(white(0), protocols_white(0))
        },
        Case {
            id: "Q04".into(),
            what: "pixels that a regular grid of one sample changes".into(),
            exact: Number(0.0),
            ours: changed_by_a_grid().into(),
            ..Case::default()
        },
        Case {
            id: "Q09".into(),
            what: "the greatest random number, 1 - 2^-53, against 32 bits of it".into(),
            exact: Number(GREATEST_BELOW_1),
            condition: Without("no number is given".into()),
            protocol: Fails,
            ..Case::of(greatest, f64::from(greatest as f32))
        },
        Case {
            id: "Q10".into(),
            what: "a picture of 65536x65536: pixels in 32 bits".into(),
            exact: Refused,
            protocol: Fails,
            ..Case::of(
                Size::new(65_536, 65_536).map(Size::pixels),
                f64::from(65_536_u32.wrapping_mul(65_536)),
            )
        },
        Case {
            id: "Q07".into(),
            what: format!("coverage of 64x64 pixels by a disc of radius {RADIUS}, summed up"),
            exact: Number(1_294.618_916_617_818),
            // The area grows with the square of the radius.
            condition: Known(2.0),
            bound: Absolute(1e-11),
            ours: area_of_the_disc().into(),
            ..Case::default()
        },
        Case {
            id: "Q08".into(),
            what: "the mean of a million samples of 0.1, as a pixel sums them".into(),
            exact: Number(0.1),
            condition: Known(1.0),
            bound: Absolute(f64::from(MILLION) * f64::EPSILON * 0.1),
            ours: plain,
            ..Case::default()
        },
        Case {
            id: "Q12".into(),
            what: "the same by the plain sum, and by Neumaier's".into(),
            exact: Number(0.1),
            condition: Known(1.0),
            bound: Ulps(1.0),
            protocol: Fails,
            ..Case::of(neumaier(tenths) / f64::from(MILLION), plain)
        },
        Case {
            id: "Q13".into(),
            what: "the byte of the samples 205, 205, 205 and 204, averaged as whole numbers".into(),
            exact: Number(204.75),
            condition: Known(1.0),
            bound: Absolute(0.5),
            protocol: Fails,
            ..Case::of(
                f64::from(byte_of_mean(bytes)),
                f64::from(protocol::mean_byte(&bytes)),
            )
        },
    ]
}
