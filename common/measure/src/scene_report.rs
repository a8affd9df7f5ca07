//! The error of one scene against its samples, so that a person can choose how
//! many samples to take.

use std::sync::{Mutex, PoisonError};

use common::{Error, Image, Sampling, SamplingReport, Scene, Settings, Size};

use crate::experiment::{Curve, Errors, Experiment, HALF_GREY_LEVEL, Point, Times};

/// The experiment with the samples of a scene: their number and their places,
/// compared with many samples of another seed.
pub fn experiment(scene: &Scene) -> Result<Experiment<'_>, Error> {
    if !scene.uses.sampling {
        let why = "is not sampled: there is nothing to choose";
        return Err(Error::Usage(format!("{} {why}", scene.name)));
    }
    // A scene that cannot be rendered fails here already.
    let settings = Settings {
        size: small(scene.defaults.size)?,
        seed: 0,
        ..scene.defaults.clone()
    };
    scene.render(&taking(&settings, Sampling::Center, 1), &())?;
    Ok(Experiment {
        question: "What do more samples buy, and where should they lie?",
        parameter: "samples per pixel",
        work: "rays",
        error: "rms error of a channel",
        exact: "against many stratified samples of two other seeds, whose own noise is taken off",
        seeds: &[0, REFERENCES[0], REFERENCES[1]],
        curves: Box::new(move || curves(scene, &settings)),
        ..Experiment::new(scene.name)
    })
}

/// The size with the same proportions, 160 pixels wide.
fn small(size: Size) -> Result<Size, Error> {
    let height = (160 * size.height() / size.width()).max(1);
    Ok(Size::new(160, height)?)
}

/// The settings with this number of samples per pixel, placed in this way.
fn taking(settings: &Settings, sampling: Sampling, samples: u32) -> Settings {
    Settings {
        sampling,
        samples,
        ..settings.clone()
    }
}

/// The channels as a screen shows them, clamped to 1; none of a failed rendering.
fn channels(image: Result<Image, Error>) -> Vec<f64> {
    let mut channels = Vec::new();
    if let Ok(image) = image {
        for color in image.pixels() {
            channels.extend(color.channels().map(|channel| channel.clamp(0.0, 1.0)));
        }
    }
    channels
}

/// The seeds of the reference pictures, which no curve uses, and the samples of each.
const REFERENCES: [u64; 2] = [0x5EED, 0x5EEE];
const MANY: u32 = 1024;

/// The channels that errors are differences from, and their own root mean square error.
struct Reference {
    channels: Vec<f64>,
    noise: f64,
}

impl Reference {
    /// The mean of two pictures with many samples. Each of them is off by noise of its own, so
    /// their difference has twice the mean square of one, and four times that of the mean.
    fn of(scene: &Scene, settings: &Settings) -> Self {
        let [a, b] = REFERENCES.map(|seed| {
            let settings = Settings {
                seed,
                ..taking(settings, Sampling::Stratified, MANY)
            };
            channels(scene.render(&settings, &()))
        });
        let (mut mean, mut squares) = (Vec::new(), 0.0);
        for (a, b) in a.iter().zip(&b) {
            mean.push(f64::midpoint(*a, *b));
            squares += (a - b) * (a - b);
        }
        Self {
            noise: (squares / mean.len() as f64).sqrt() / 2.0,
            channels: mean,
        }
    }

    /// The errors of the channels of a picture, three of each pixel.
    fn errors(&self, image: Result<Image, Error>) -> Errors {
        let channels = channels(image);
        let pairs = channels.iter().zip(&self.channels);
        let errors = Errors::of_inputs(3, pairs.map(|(channel, exact)| channel - exact));
        errors.without(self.noise)
    }
}

/// Half grey levels that adaptive sampling is asked for.
const LEVELS: [f64; 6] = [16.0, 8.0, 4.0, 2.0, 1.0, 0.5];

fn curves<'a>(scene: &'a Scene, settings: &Settings) -> Vec<Curve<'a>> {
    let reference = Reference::of(scene, settings);
    let mut curves = Vec::new();
    for (method, sampling) in [
        ("random", Sampling::Random),
        ("regular", Sampling::Regular),
        ("stratified", Sampling::Stratified),
    ] {
        let mut points = Vec::new();
        for side in [1, 2, 4, 8] {
            let settings = taking(settings, sampling, side * side);
            points.push(with_samples(scene, settings, &reference));
        }
        curves.push(Curve::new(method, points));
    }
    let mut points = Vec::new();
    for levels in LEVELS {
        let settings = Settings {
            max_error: Some(levels * HALF_GREY_LEVEL),
            ..taking(settings, settings.sampling, 1024)
        };
        points.push(within_an_error(scene, settings, &reference));
    }
    curves.push(Curve::new("adaptive", points));
    curves
}

/// The measurement of a picture with a number of samples.
fn with_samples<'a>(scene: &'a Scene, settings: Settings, reference: &Reference) -> Point<'a> {
    let samples = f64::from(settings.samples);
    Point {
        parameter: samples,
        work: samples * settings.size.pixels() as f64,
        errors: reference.errors(scene.render(&settings, &())),
        times: Times::of(move || scene.render(&settings, &())),
    }
}

/// The measurement of a picture by adaptive sampling, with the samples that it takes.
fn within_an_error<'a>(scene: &'a Scene, settings: Settings, reference: &Reference) -> Point<'a> {
    let sampled = Mutex::new(SamplingReport::default());
    let image = scene.render(&settings, &sampled);
    let sampled = sampled.into_inner().unwrap_or_else(PoisonError::into_inner);
    let rays = sampled.samples as f64;
    Point {
        parameter: rays / settings.size.pixels() as f64,
        work: rays,
        errors: reference.errors(image),
        times: Times::of(move || scene.render(&settings, &Mutex::new(SamplingReport::default()))),
    }
}

#[cfg(test)]
mod tests {
    use common::Color;

    use super::*;

    /// The brightness of this scene is 1/n with n samples, twice or half of that with other
    /// samplings, and the requested error with adaptive sampling; the reference's is 1/4.
    fn scene() -> Scene {
        let scene = Scene::sampled("fading", "", |settings, progress| {
            assert_eq!(settings.size, Size::new(160, 1)?);
            let samples = f64::from(settings.samples);
            let gray = match (settings.max_error, settings.sampling) {
                (Some(asked), _) => {
                    progress.sampled(&SamplingReport {
                        pixels: 160,
                        samples: 320,
                        most: 2,
                        ..SamplingReport::default()
                    });
                    asked
                }
                (None, Sampling::Stratified) if settings.seed != 0 => 0.25,
                (None, Sampling::Random) => 1.0 / samples,
                (None, Sampling::Regular) => 2.0 / samples,
                (None, _) => 0.5 / samples,
            };
            Image::from_fn(settings.size, |_, _| Color::gray(gray))
        });
        scene.with_defaults(Settings {
            size: Size::new(320, 2).unwrap(),
            ..Settings::default()
        })
    }

    #[test]
    fn errors_and_rays_come_from_the_pictures() {
        let scene = scene();
        let curves = (experiment(&scene).unwrap().curves)();
        // Brighter than 1 cannot be seen.
        let shown = [
            ("random", [1.0, 0.25, 1.0 / 16.0, 1.0 / 64.0]),
            ("regular", [1.0, 0.5, 0.125, 1.0 / 32.0]),
            ("stratified", [0.5, 0.125, 1.0 / 32.0, 1.0 / 128.0]),
        ];
        for (curve, (method, grays)) in curves.iter().zip(shown) {
            assert_eq!(curve.method, method);
            let samples = [1.0, 4.0, 16.0, 64.0].into_iter().zip(grays);
            for (point, (n, gray)) in curve.points.iter().zip(samples) {
                let expected = [n, 160.0 * n, f64::abs(gray - 0.25)];
                assert_eq!(
                    [point.parameter, point.work, point.errors.rms],
                    expected,
                    "{method}"
                );
            }
        }
        assert_eq!((curves.len(), curves[3].method), (4, "adaptive"));
        for (point, levels) in curves[3].points.iter().zip([16.0, 8.0, 4.0, 2.0, 1.0, 0.5]) {
            assert_eq!([point.parameter, point.work], [2.0, 320.0]);
            assert!((point.errors.rms - (0.25 - levels / 510.0)).abs() < 1e-12);
        }
    }

    #[test]
    fn pictures_are_made_160_pixels_wide_and_keep_their_shape() {
        let small = |width, height| small(Size::new(width, height).unwrap());
        assert_eq!(small(640, 480).unwrap().to_string(), "160x120");
        assert_eq!(small(480, 270).unwrap().to_string(), "160x90");
        assert_eq!(small(1600, 1).unwrap().to_string(), "160x1");
        assert!(small(1, 32_768).is_err());
    }
}
