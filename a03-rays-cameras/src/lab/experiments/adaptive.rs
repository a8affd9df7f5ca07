//! The cost of a given error with adaptive sampling.

use std::sync::Mutex;

use a02_math::Point3;
use common::{ArgumentError, Color, Image, Sampled, Sampling, Settings, Size};
use measure::Effort;
use measure::experiment::{Axis, Curve, Experiment, HALF_GREY_LEVEL, Point};

use super::coverage::{disc_coverage, in_disc};
use crate::lab::extremes::{AHEAD, UP};
use crate::{OrthographicCamera, Ray, View};

const SIDE: u32 = 64;

/// A picture of the disc, and how its pixels were sampled.
fn picture(settings: &Settings) -> Option<(Image, Sampled)> {
    // Rays start at their place in the picture, in pixels.
    let (middle, height) = (Point3::new(32.0, 32.0, 0.0), f64::from(SIDE - 1));
    let camera = OrthographicCamera::new(middle, AHEAD, UP, height).ok()?;
    let disc = |ray: &Ray| Color::gray(in_disc(ray.origin().x(), ray.origin().y()).into());
    let (view, sampled) = (View::new(camera, disc).boxed(), Mutex::default());
    let image = view.render(settings, &sampled).ok()?;
    Some((image, sampled.into_inner().ok()?))
}

fn errors(image: &Image) -> impl Iterator<Item = f64> {
    let row = |y: u32| (0..SIDE).map(move |x| disc_coverage(x.into(), y.into()));
    let means = (0..SIDE).rev().flat_map(row);
    let pixels = image.pixels().iter().zip(means);
    pixels.map(|(color, mean)| color.r - mean)
}

fn curves(effort: Effort) -> Result<Vec<Curve<'static>>, ArgumentError> {
    let settings = Settings {
        size: Size::new(SIDE, SIDE)?,
        ..Settings::default()
    };
    let sides = &[1, 2, 4, 8, 16, 32, 64][..effort.choose(5, 7)];
    let bounds = &[16.0, 8.0, 4.0, 2.0, 1.0, 0.5, 0.25][..effort.choose(6, 7)];
    let everywhere = sides.iter().filter_map(|side| {
        let settings = Settings {
            samples: side * side,
            sampling: Sampling::Stratified,
            ..settings.clone()
        };
        let (image, _) = picture(&settings)?;
        let samples = f64::from(settings.samples * SIDE * SIDE);
        let run = move || picture(&settings);
        Some(Point::new(samples, samples, errors(&image), run))
    });
    let mut promised = Vec::new();
    let adaptive = bounds.iter().filter_map(|levels| {
        let settings = Settings {
            samples: 1 << 16,
            max_error: Some(levels * HALF_GREY_LEVEL),
            ..settings.clone()
        };
        let (image, sampled) = picture(&settings)?;
        let (largest, samples) = (sampled.max_error(), sampled.samples as f64);
        let again = settings.clone();
        let run = move || picture(&again);
        promised.push(Point::estimate(samples, samples, largest, run));
        let run = move || picture(&settings);
        Some(Point::new(samples, samples, errors(&image), run))
    });
    Ok(vec![
        // Mitchell, Consequences of Stratified Sampling in Graphics, 1996.
        Curve::new("stratified everywhere", everywhere).with_slope(-0.75, (1e4, 1e9)),
        Curve::new("adaptive", adaptive),
        Curve::new("adaptive, as promised", promised),
    ])
}

pub fn experiment() -> Experiment<'static> {
    Experiment::new("samples-adaptive")
        .asking("What does an error cost if samples are taken only where they are needed?")
        .over(Axis::Work, "samples", "rays")
        .with_error("rms error of a pixel of a disc's picture")
        .with_exact("against the pixel's mean in closed form")
        .with_seeds(&[0])
        .with_curves(|effort| curves(effort).unwrap_or_default())
}
