//! The cost of a given error with adaptive sampling.

use std::sync::Mutex;

use a02_math::{Point3, Vector3};
use common::{ArgumentError, Color, Error, Image, Sampled, Sampling, Settings, Size};
use engine::adaptive;
use measure::Effort;
use measure::experiment::{Axis, Curve, Experiment, HALF_GREY_LEVEL, Point, Unit};

use super::coverage::{DISC, disc_coverage};
use crate::{Camera, Ray, render};

const SIDE: u32 = 64;

/// Radiance of the disc at a position of the picture, relative to the middles of pixels;
/// [`DISC`] is relative to their corners.
fn disc(x: f64, y: f64) -> Color {
    Color::gray(DISC.contains(x + 0.5, y + 0.5).into())
}

/// A camera whose rays start at their position in the picture, in pixels.
struct Places;

impl Camera for Places {
    fn ray_for(&self, _: Size, x: f64, y: f64) -> Ray {
        Ray::derived(Point3::new(x, y, 0.0), Vector3::new(0.0, 0.0, -1.0))
    }
}

fn with_samples_everywhere(settings: &Settings) -> Result<Image, Error> {
    let light = |ray: &Ray| disc(ray.origin().x(), ray.origin().y());
    render(&Places, light, settings, &())
}

/// A picture of the disc, the number of its samples, and the largest error that its check
/// leaves possible.
fn with_max_error(max_error: f64, settings: &Settings) -> Option<(Image, f64, f64)> {
    let sampled = Mutex::new(Sampled::default());
    let image = adaptive::render_image(max_error, disc, settings, &sampled).ok()?;
    let sampled = sampled.into_inner().ok()?;
    Some((image, sampled.samples as f64, sampled.error()[1]))
}

fn errors(image: &Image) -> impl Iterator<Item = f64> {
    let row = |y: u32| (0..SIDE).map(move |x| disc_coverage(x.into(), y.into()));
    let means = (0..SIDE).rev().flat_map(row);
    let pixels = image.pixels().iter().zip(means);
    pixels.map(|(color, mean)| color.r - mean)
}

fn stratified(settings: &Settings, side: u32) -> Option<Point<'static>> {
    let settings = Settings {
        samples: side * side,
        sampling: Sampling::Stratified,
        ..settings.clone()
    };
    let image = with_samples_everywhere(&settings).ok()?;
    let samples = f64::from(settings.samples) * f64::from(SIDE * SIDE);
    let run = move || with_samples_everywhere(&settings).map_or(0.0, |_| samples);
    Some(Point::new(samples, samples, errors(&image), run))
}

fn adaptive(settings: &Settings, max_error: f64, as_promised: bool) -> Option<Point<'static>> {
    let settings = Settings {
        samples: 1 << 16,
        ..settings.clone()
    };
    let (image, samples, largest) = with_max_error(max_error, &settings)?;
    let run = move || with_max_error(max_error, &settings).map_or(0.0, |(_, samples, _)| samples);
    Some(if as_promised {
        Point::estimate(samples, samples, largest, run)
    } else {
        Point::new(samples, samples, errors(&image), run)
    })
}

fn curves(effort: Effort) -> Result<Vec<Curve<'static>>, ArgumentError> {
    let settings = Settings {
        size: Size::new(SIDE, SIDE)?,
        ..Settings::default()
    };
    let sides = &[1, 2, 4, 8, 16, 32, 64][..effort.choose(5, 7)];
    let bounds = &[16.0, 8.0, 4.0, 2.0, 1.0, 0.5, 0.25][..effort.choose(6, 7)];
    let everywhere = sides.iter().filter_map(|side| stratified(&settings, *side));
    let settings = &settings;
    let adaptive = |as_promised| {
        let bounds = bounds.iter().map(|levels| levels * HALF_GREY_LEVEL);
        bounds.filter_map(move |bound| adaptive(settings, bound, as_promised))
    };
    Ok(vec![
        // Mitchell, Consequences of Stratified Sampling in Graphics, 1996.
        Curve::new("stratified everywhere", everywhere).with_slope(-0.75, (1e4, 1e9)),
        Curve::new("adaptive", adaptive(false)),
        Curve::new("adaptive, as promised", adaptive(true)).with_remark(
            "the largest error that the renderer's check leaves possible, with 95 % confidence",
        ),
    ])
}

pub fn experiment() -> Experiment<'static> {
    Experiment {
        name: "samples-adaptive",
        about: "What does an error cost if samples are taken only where they are needed?",
        knob: "samples",
        work: "rays",
        error: "rms error of a pixel of a disc's picture",
        unit: Unit::Light,
        exact: "against the pixel's mean in closed form",
        seeds: &[0],
        against: Axis::Work,
        curves: Box::new(|effort| curves(effort).unwrap_or_default()),
    }
}
