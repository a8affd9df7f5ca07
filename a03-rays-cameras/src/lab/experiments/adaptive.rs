//! What an error costs where samples are taken only where they are needed.

use std::sync::Mutex;

use a02_math::{Point3, Vector3};
use common::{ArgumentError, Color, Image, Sampled, Sampling, Settings, Size};
use measure::Effort;
use measure::experiment::{Axis, Curve, Experiment, HALF_GREY_LEVEL, Point, Slope};

use super::coverage::{DISC, disc_coverage};
use crate::{Camera, Ray, render};

const SIDE: u32 = 64;

/// Rays that start at their place in the picture, in pixels. A pixel is named
/// by its corner.
struct Places;

impl Camera for Places {
    fn ray_for(&self, _: Size, x: f64, y: f64) -> Ray {
        let place = Point3::new(x + 0.5, y + 0.5, 0.0);
        Ray::derived(place, Vector3::new(0.0, 0.0, -1.0))
    }
}

/// A picture of the disc, how many samples it took, and its error as it is
/// estimated.
fn disc(settings: &Settings) -> Option<(Image, f64, f64)> {
    let light = |ray: &Ray| {
        let inside = DISC.contains(ray.origin().x(), ray.origin().y());
        Color::gray(if inside { 1.0 } else { 0.0 })
    };
    let told = Mutex::new(Sampled::default());
    let image = render(&Places, light, settings, &told).ok()?;
    let told = told.into_inner().ok()?;
    Some((image, told.samples as f64, told.error()))
}

fn errors(image: &Image) -> impl Iterator<Item = f64> {
    let rows = (0..SIDE).rev().zip(image.rows());
    rows.flat_map(|(y, row)| {
        let row = (0_u32..).zip(row);
        row.map(move |(x, color)| color.r - disc_coverage(x.into(), y.into()))
    })
}

fn stratified(settings: &Settings, side: u32) -> Option<Point<'static>> {
    let settings = Settings {
        samples: side * side,
        sampling: Sampling::Stratified,
        ..settings.clone()
    };
    let (image, ..) = disc(&settings)?;
    let samples = f64::from(settings.samples) * f64::from(SIDE * SIDE);
    let run = move || disc(&settings).map_or(0.0, |_| samples);
    Some(Point::new(samples, samples, errors(&image), run))
}

fn adaptive(settings: &Settings, asked: f64, as_estimated: bool) -> Option<Point<'static>> {
    let settings = Settings {
        samples: 1 << 16,
        max_error: Some(asked),
        ..settings.clone()
    };
    let (image, samples, estimate) = disc(&settings)?;
    let errors: Vec<_> = if as_estimated {
        vec![estimate]
    } else {
        errors(&image).collect()
    };
    let run = move || disc(&settings).map_or(0.0, |(_, samples, _)| samples);
    Some(Point::new(samples, samples, errors, run))
}

fn curves(effort: Effort) -> Result<Vec<Curve<'static>>, ArgumentError> {
    let settings = Settings {
        size: Size::new(SIDE, SIDE)?,
        ..Settings::default()
    };
    let sides = &[1, 2, 4, 8, 16, 32, 64][..effort.choose(5, 7)];
    let asked = [16.0, 8.0, 4.0, 2.0, 1.0, 0.5, 0.25].map(|levels| levels * HALF_GREY_LEVEL);
    let asked = &asked[..effort.choose(6, 7)];
    let adaptive = |as_estimated: bool| {
        let points = asked.iter();
        points
            .filter_map(|asked| adaptive(&settings, *asked, as_estimated))
            .collect()
    };
    Ok(vec![
        Curve {
            method: "stratified everywhere",
            remark: "",
            // Mitchell, Consequences of Stratified Sampling in Graphics, 1996.
            slope: Some(Slope {
                expected: -0.75,
                tolerance: 0.05,
                between: (1e4, 1e9),
            }),
            points: sides
                .iter()
                .filter_map(|side| stratified(&settings, *side))
                .collect(),
        },
        Curve {
            method: "adaptive",
            remark: "",
            slope: None,
            points: adaptive(false),
        },
        Curve {
            method: "adaptive, as estimated",
            remark: "the error that the renderer reckons with; it should be the greater one",
            slope: None,
            points: adaptive(true),
        },
    ])
}

pub fn experiment() -> Experiment<'static> {
    Experiment {
        name: "samples-adaptive",
        about: "what does an error cost if samples are taken only where they are needed?",
        knob: "samples",
        work: "rays",
        error: "of a pixel of a disc's picture, against its mean in closed form",
        against: Axis::Work,
        curves: Box::new(|effort| curves(effort).unwrap_or_default()),
    }
}
