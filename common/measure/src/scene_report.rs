//! The error of one scene against its samples, so that a person can choose how
//! many samples to take.

use std::sync::{Mutex, PoisonError};

use common::{Error, Image, Sampling, SamplingReport, Scene, Settings, Size};

use crate::Effort;
use crate::experiment::{Axis, Curve, Experiment, HALF_GREY_LEVEL, Point};

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
    Ok(Experiment::new(scene.name)
        .asking("What do more samples buy, and where should they lie?")
        .over(Axis::Work, "samples a pixel", "rays")
        .with_error("rms error of a channel")
        .with_exact("against many stratified samples of another seed")
        .with_seeds(&[0, REFERENCE])
        .with_curves(move |effort| curves(scene, &settings, effort)))
}

/// The size with the same proportions, 160 pixels wide.
fn small(size: Size) -> Result<Size, Error> {
    let height = (160 * size.height() / size.width()).max(1);
    Ok(Size::new(160, height)?)
}

/// The settings with this number of samples a pixel, placed in this way.
fn taking(settings: &Settings, sampling: Sampling, samples: u32) -> Settings {
    Settings {
        sampling,
        samples,
        ..settings.clone()
    }
}

/// The channels as a screen shows them, clamped to 1; none of a failed rendering.
fn channels(image: Result<Image, Error>) -> Vec<f64> {
    let pixels = image.map_or(Vec::new(), |image| image.pixels().to_vec());
    let shown = |color: common::Color| color.map(|c| c.clamp(0.0, 1.0)).channels();
    pixels.into_iter().flat_map(shown).collect()
}

/// The seed of the reference: no curve uses it.
const REFERENCE: u64 = 0x5EED;

fn curves<'a>(scene: &'a Scene, settings: &Settings, effort: Effort) -> Vec<Curve<'a>> {
    let sides = &[1_u32, 2, 4, 8, 16][..effort.choose(4, 5)];
    let many = effort.choose(32, 64).pow(2) as u32;
    let reference = Settings {
        seed: REFERENCE,
        ..taking(settings, Sampling::Stratified, many)
    };
    let reference = channels(scene.render(&reference, &()));
    let errors = |image| {
        let channels = channels(image);
        let pairs = channels.iter().zip(&reference);
        pairs.map(|(a, b)| a - b).collect::<Vec<_>>()
    };
    let pixels = settings.size.pixels() as f64;
    let curve = |(method, sampling)| {
        let point = |side: &u32| {
            let settings = taking(settings, sampling, side * side);
            let samples = f64::from(settings.samples);
            let rays = samples * pixels;
            let errors = errors(scene.render(&settings, &()));
            Point::new(samples, rays, errors, move || scene.render(&settings, &()))
        };
        Curve::new(method, sides.iter().map(point))
    };
    // Adaptive sampling for an error in half grey levels.
    let adaptive = |levels: f64| {
        let settings = Settings {
            max_error: Some(levels * HALF_GREY_LEVEL),
            ..taking(settings, settings.sampling, 1024)
        };
        let render = move || {
            let sampled = Mutex::new(SamplingReport::default());
            let image = scene.render(&settings, &sampled);
            let sampled = sampled.into_inner().unwrap_or_else(PoisonError::into_inner);
            (image, sampled.samples as f64)
        };
        let (image, rays) = render();
        Point::new(rays / pixels, rays, errors(image), render)
    };
    let methods = [
        ("random", Sampling::Random),
        ("regular", Sampling::Regular),
        ("stratified", Sampling::Stratified),
    ];
    let adaptive = [16.0, 8.0, 4.0, 2.0, 1.0, 0.5].map(adaptive);
    let adaptive = Curve::new("adaptive", adaptive);
    methods.map(curve).into_iter().chain([adaptive]).collect()
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
                (None, Sampling::Stratified) if settings.seed == REFERENCE => 0.25,
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
        let curves = (experiment(&scene).unwrap().curves)(Effort::Quick);
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
                    [point.parameter, point.work, point.rms],
                    expected,
                    "{method}"
                );
            }
        }
        assert_eq!((curves.len(), curves[3].method), (4, "adaptive"));
        for (point, levels) in curves[3].points.iter().zip([16.0, 8.0, 4.0, 2.0, 1.0, 0.5]) {
            assert_eq!([point.parameter, point.work], [2.0, 320.0]);
            assert!((point.rms - (0.25 - levels / 510.0)).abs() < 1e-12);
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
