//! The whole renderer against a closed form: the brightness of a matt ball, the
//! moon for example, depends only on the angle between the light and the eye. At
//! the phase angle a its mean brightness is `(2/3) (sin a + (π - a) cos a) / π`.
//! (Lambert, Photometria, 1760)
//!
//! The pixels at the edge count as a whole or not at all: an error of `n^(-3/2)`
//! for n pixels across. At full moon the edge is dark, and the error of these
//! pixels is smaller: `n^-2`.

use std::f64::consts::PI;

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{OrthographicCamera, PixelRandom, render};
use a04_intersections::Sphere;
use common::{Color, Error, Settings, Size};
use measure::experiment::{Axis, Curve, Experiment, Point, Unit};

use crate::{DirectionalLight, Lambert, LitWorld};

/// Side of the visible square: no ball is larger than 2.2 across.
const VIEW: f64 = 2.4;

pub fn experiment() -> Experiment<'static> {
    Experiment {
        name: "lambert-phase",
        about: "How many pixels does the mean brightness of a matt ball need?",
        knob: "pixels across",
        work: "rays",
        error: "rms error of the mean brightness",
        unit: Unit::Other("full moon = 2/3"),
        exact: "against the closed form, for random balls",
        seeds: &[1760],
        against: Axis::Work,
        curves: Box::new(|effort| {
            let balls = effort.choose(48, 96) as u32;
            let sizes = &[32, 48, 64, 96, 128, 192, 256][..effort.choose(5, 7)];
            let point = |phase: f64, pixels: u32| {
                let mean = move |ball| mean(phase, pixels, ball).unwrap_or(f64::NAN);
                let sin = libm::sin(phase);
                let exact = 2.0 / 3.0 * (sin + (PI - phase) * libm::cos(phase)) / PI;
                let errors: Vec<_> = (0..balls).map(|ball| mean(ball) - exact).collect();
                let pixels = f64::from(pixels);
                let rays = f64::from(balls) * pixels * pixels;
                Point::new(pixels, rays, errors, move || {
                    (0..balls).map(mean).sum::<f64>()
                })
            };
            let curve = |phase, method, slope: f64| {
                let points = sizes.iter().map(|pixels| point(phase, *pixels));
                Curve::new(method, points).with_slope(slope, (0.0, f64::INFINITY))
            };
            vec![
                curve(0.0, "full", -1.0),
                curve(0.5, "phase 0.5", -0.75),
                curve(1.0, "phase 1", -0.75),
                curve(2.0, "phase 2", -0.75),
            ]
        }),
    }
}

/// The mean brightness of a ball whose centre and radius are no multiples of a
/// pixel.
fn mean(phase: f64, pixels: u32, ball: u32) -> Result<f64, Error> {
    let across = f64::from(pixels);
    let pixel = VIEW / across;
    let random = PixelRandom::new(1760, ball, 0);
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
