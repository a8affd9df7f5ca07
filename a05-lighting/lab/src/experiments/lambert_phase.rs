//! The brightness of a matt ball, by how many pixels it is wide.

use std::f64::consts::PI;

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{OrthographicCamera, PixelRandom, render};
use a04_intersections::Sphere;
use common::{Color, Error, Settings, Size};
use measure::Effort;
use measure::experiment::{Curve, Curves, Errors, Experiment, Point, Slope, Times, Unit};

use a05_lighting::{DirectionalLight, Lambert, LitWorld};

/// The whole renderer against a closed form: the brightness of a matt ball, the
/// moon for example, depends only on the angle between the light and the eye. At
/// the phase angle a its mean brightness is `(2/3) (sin a + (π - a) cos a) / π`.
/// (Lambert, Photometria, 1760)
///
/// The pixels at the edge count as a whole or not at all: an error of `n^(-3/2)`
/// for n pixels across. At full moon the edge is dark, and the error of these
/// pixels is smaller: `n^-2`.
pub fn experiment() -> Experiment<'static> {
    Experiment {
        question: "How many pixels does the mean brightness of a matt ball need?",
        curves_are: Curves::Problems,
        parameter: "pixels across",
        work: "rays",
        error: "rms error of the mean brightness",
        unit: Unit::Other("full moon = 2/3"),
        exact: "against the closed form, for random balls",
        seeds: &[SEED],
        curves: Box::new(curves),
        ..Experiment::new("lambert-phase")
    }
}

const SEED: u64 = 1760;

fn curves(effort: Effort) -> Vec<Curve<'static>> {
    let curve = |phase, name, slope| Curve {
        slope: Some(Slope {
            value: slope,
            between: 0.0..=f64::INFINITY,
        }),
        ..Curve::new(name, points(phase, effort))
    };
    vec![
        curve(0.0, "full", -1.0),
        curve(0.5, "phase 0.5", -0.75),
        curve(1.0, "phase 1", -0.75),
        curve(2.0, "phase 2", -0.75),
    ]
}

/// The errors of random balls at a phase angle, in pictures of all sizes.
fn points(phase: f64, effort: Effort) -> Vec<Point<'static>> {
    let balls = effort.choose(48, 96) as u32;
    let exact = 2.0 / 3.0 * (libm::sin(phase) + (PI - phase) * libm::cos(phase)) / PI;
    let mut points = Vec::new();
    for pixels in &[32, 48, 64, 96, 128, 192, 256][..effort.choose(5, 7)] {
        let mean = move |ball| mean_brightness(phase, *pixels, ball).unwrap_or(f64::NAN);
        let across = f64::from(*pixels);
        points.push(Point {
            parameter: across,
            work: f64::from(balls) * across * across,
            errors: Errors::of((0..balls).map(|ball| mean(ball) - exact)),
            times: Times::of(move || (0..balls).map(mean).sum::<f64>()),
        });
    }
    points
}

/// Width and height of the picture.
const VIEW: f64 = 2.4;

/// The mean brightness of a ball whose centre and radius are no multiples of a
/// pixel.
fn mean_brightness(phase: f64, pixels: u32, ball: u32) -> Result<f64, Error> {
    let across = f64::from(pixels);
    let pixel = VIEW / across;
    let random = PixelRandom::new(SEED, ball, 0);
    let centre = Point3::new(random.uniform(0) * pixel, random.uniform(1) * pixel, 0.0);
    let radius = 0.8 + 0.3 * random.uniform(2);
    let light = Vector3::new(-libm::sin(phase), 0.0, -libm::cos(phase));
    let white = Box::new(Lambert::new(Color::WHITE)?);
    let world = LitWorld::new(Color::BLACK, Color::BLACK)?
        .with(Sphere::new(centre, radius)?, white)
        .lit_by(Box::new(DirectionalLight::new(Color::WHITE, light)?));

    // The camera's `s` is the distance from the first row of pixels to the last.
    let (gaze, up) = (Vector3::new(0.0, 0.0, -1.0), Vector3::new(0.0, 1.0, 0.0));
    let s = pixel * (across - 1.0);
    let camera = OrthographicCamera::new(Point3::new(0.0, 0.0, 9.0), gaze, up, s)?;
    let settings = Settings {
        size: Size::new(pixels, pixels)?,
        ..Settings::default()
    };
    let image = render(&camera, |ray| world.color_for(ray), &settings, &())?;
    let sum: f64 = image.pixels().iter().map(|color| color.r).sum();
    Ok(sum * pixel * pixel / (PI * radius * radius))
}
