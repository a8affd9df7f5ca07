//! The error of one scene against its samples, so that a person can choose how
//! many samples to take.

use std::sync::{Mutex, PoisonError};

use common::{Error, Image, Renderer, Sampling, SamplingReport, Scene, Settings, Size};

use crate::experiment::{Curve, Errors, Experiment, HALF_GREY_LEVEL, Point, Times};

/// The experiment with the samples of a scene: their number and their places,
/// compared with many samples of another seed.
pub fn experiment(scene: &Scene) -> Result<Experiment<'_>, Error> {
    let samples = Samples::new(scene)?;
    Ok(Experiment {
        curves: Box::new(move || samples.curves()),
        ..without_curves(scene.name)
    })
}

/// The same, whose curves are measured elsewhere.
pub fn without_curves(name: &str) -> Experiment<'_> {
    Experiment {
        question: "What do more samples buy, and where should they lie?",
        parameter: "samples per pixel",
        work: "rays",
        error: "rms error of a channel",
        exact: "against many stratified samples of two other seeds, whose own noise is taken off",
        seeds: &[0, REFERENCES[0], REFERENCES[1]],
        ..Experiment::new(name)
    }
}

/// How samples are placed in the pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Method {
    /// Its name.
    pub name: &'static str,
    /// The places; none of adaptive sampling.
    sampling: Option<Sampling>,
    /// The samples per pixel; of adaptive sampling the error that it is asked for, in half grey levels.
    pub values: &'static [f64],
}

impl Method {
    /// The least number of samples per pixel, from this one on, that the method can take. That of adaptive
    /// sampling is a mean, which may be any number.
    #[must_use]
    pub fn next(self, samples: f64) -> f64 {
        match self.sampling {
            None => samples,
            Some(sampling) if sampling.is_grid() => {
                let cells = samples.sqrt().ceil();
                cells * cells
            }
            Some(_) => samples.ceil(),
        }
    }
}

const SQUARES: &[f64] = &[1.0, 4.0, 16.0, 64.0];

/// The methods of a report.
pub const METHODS: [Method; 4] = [
    Method {
        name: "random",
        sampling: Some(Sampling::Random),
        values: SQUARES,
    },
    Method {
        name: "regular",
        sampling: Some(Sampling::Regular),
        values: SQUARES,
    },
    Method {
        name: "stratified",
        sampling: Some(Sampling::Stratified),
        values: SQUARES,
    },
    Method {
        name: "adaptive",
        sampling: None,
        values: &[16.0, 8.0, 4.0, 2.0, 1.0, 0.5],
    },
];

/// One sample, which all methods have as their first point but for its place.
pub const MIDDLE: Method = Method {
    name: "one in the middle",
    sampling: Some(Sampling::Center),
    values: &[1.0],
};

/// The samples of a scene, measured point by point.
pub struct Samples<'a> {
    scene: &'a Scene,
    settings: Settings,
}

impl<'a> Samples<'a> {
    /// The samples of a scene, which fails here already if it cannot be rendered.
    pub fn new(scene: &'a Scene) -> Result<Self, Error> {
        if !scene.uses.sampling {
            let why = "is not sampled: there is nothing to choose";
            return Err(Error::Usage(format!("{} {why}", scene.name)));
        }
        let settings = Settings {
            size: small(scene.defaults.size)?,
            seed: 0,
            ..scene.defaults.clone()
        };
        scene.render(&taking(&settings, Sampling::Center, 1), &())?;
        Ok(Self { scene, settings })
    }

    /// The size of the pictures.
    pub const fn size(&self) -> Size {
        self.settings.size
    }

    fn curves(&self) -> Vec<Curve<'a>> {
        let [a, b] = REFERENCES.map(|seed| self.reference_picture(seed));
        let reference = Reference::of(&a, &b);
        let mut curves = Vec::new();
        for method in METHODS {
            let values = method.values.iter();
            let points = values.map(|value| self.point(method, *value, &reference));
            curves.push(Curve::new(method.name, points));
        }
        curves
    }

    /// The channels of a picture with many samples. The engine, whose colours are the same, takes less
    /// time for it.
    pub fn reference_picture(&self, seed: u64) -> Vec<f64> {
        let settings = Settings {
            seed,
            renderer: Renderer::Engine,
            ..taking(&self.settings, Sampling::Stratified, MANY)
        };
        channels(&self.scene.render(&settings, &()))
    }

    /// The settings of a method at one of its values.
    fn settings(&self, method: Method, value: f64) -> Settings {
        match method.sampling {
            Some(sampling) => taking(&self.settings, sampling, value as u32),
            None => Settings {
                max_error: Some(value * HALF_GREY_LEVEL),
                ..taking(&self.settings, self.settings.sampling, 1024)
            },
        }
    }

    /// The picture of a method at one of its values.
    pub fn picture(&self, method: Method, value: f64) -> Result<Image, Error> {
        self.scene.render(&self.settings(method, value), &())
    }

    /// The measurement of a method at one of its values.
    pub fn point(&self, method: Method, value: f64, reference: &Reference) -> Point<'a> {
        let settings = self.settings(method, value);
        let sampled = Mutex::new(SamplingReport::default());
        let image = self.scene.render(&settings, &sampled);
        let sampled = sampled.into_inner().unwrap_or_else(PoisonError::into_inner);
        let pixels = settings.size.pixels() as f64;
        // Only adaptive sampling reports its samples.
        let work = match method.sampling {
            Some(_) => value * pixels,
            None => sampled.samples as f64,
        };
        let scene = self.scene;
        Point {
            parameter: work / pixels,
            work,
            errors: Errors::of_inputs(3, reference.differences(&image)).without(reference.noise),
            times: Times::of(move || {
                scene.render(&settings, &Mutex::new(SamplingReport::default()))
            }),
        }
    }
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
fn channels(image: &Result<Image, Error>) -> Vec<f64> {
    let mut channels = Vec::new();
    if let Ok(image) = image {
        for color in image.pixels() {
            channels.extend(color.channels().map(|channel| channel.clamp(0.0, 1.0)));
        }
    }
    channels
}

/// The seeds of the reference pictures, which no curve uses, and the samples of each.
pub const REFERENCES: [u64; 2] = [0x5EED, 0x5EEE];
const MANY: u32 = 1024;

/// The channels that errors are differences from, and their own root mean square error.
pub struct Reference {
    channels: Vec<f64>,
    noise: f64,
}

impl Reference {
    /// The mean of two pictures with many samples. Each of them is off by noise of its own, so
    /// their difference has twice the mean square of one, and four times that of the mean.
    pub fn of(a: &[f64], b: &[f64]) -> Self {
        let (mut mean, mut squares) = (Vec::new(), 0.0);
        for (a, b) in a.iter().zip(b) {
            mean.push(f64::midpoint(*a, *b));
            squares += (a - b) * (a - b);
        }
        Self {
            noise: (squares / mean.len() as f64).sqrt() / 2.0,
            channels: mean,
        }
    }

    /// By how much the channels of a picture are too bright, three of each pixel.
    pub fn differences(&self, image: &Result<Image, Error>) -> Vec<f64> {
        let channels = channels(image);
        let pairs = channels.iter().zip(&self.channels);
        pairs.map(|(channel, exact)| channel - exact).collect()
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
