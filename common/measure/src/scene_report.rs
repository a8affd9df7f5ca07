//! The error of one scene against its samples, so that a person can choose how
//! many samples to take.

use std::sync::{Mutex, PoisonError};

use common::{Error, Image, Sampled, Sampling, Scene, Settings, Size};

use crate::Effort;
use crate::experiment::{Axis, Curve, Experiment, HALF_GREY_LEVEL, Point, Unit};

/// The experiment with the samples of a scene: their number and their places,
/// compared with many samples of another seed.
pub fn experiment(scene: &Scene) -> Result<Experiment<'_>, Error> {
    if !scene.uses.sampling {
        let name = scene.name;
        return Err(Error::Usage(format!(
            "{name} is not sampled: there is nothing to choose"
        )));
    }
    // A scene that cannot be rendered fails here already.
    let size = small(scene.defaults.size)?;
    render(scene, size, Sampling::Center, 1, 0)?;
    Ok(Experiment {
        name: scene.name,
        about: "What do more samples buy, and where should they lie?",
        knob: "samples a pixel",
        work: "rays",
        error: "rms error of a channel",
        unit: Unit::Light,
        exact: "against many stratified samples of another seed",
        seeds: &[0, REFERENCE],
        against: Axis::Work,
        curves: Box::new(move |effort| curves(scene, size, effort)),
    })
}

/// The size with the same proportions, 160 pixels wide.
fn small(size: Size) -> Result<Size, Error> {
    let height = (160 * size.height() / size.width()).max(1);
    Ok(Size::new(160, height)?)
}

fn render(
    scene: &Scene,
    size: Size,
    sampling: Sampling,
    samples: u32,
    seed: u64,
) -> Result<Image, Error> {
    let settings = Settings {
        size,
        samples,
        sampling,
        seed,
        ..scene.defaults.clone()
    };
    scene.render(&settings, &())
}

/// The channels as a screen shows them, clamped to 1.
fn channels(image: Option<Image>) -> Vec<f64> {
    let pixels = image.map_or(Vec::new(), |image| image.pixels().to_vec());
    let shown = |color: common::Color| color.map(|c| c.clamp(0.0, 1.0)).channels();
    pixels.into_iter().flat_map(shown).collect()
}

/// The seed of the reference: no curve uses it.
const REFERENCE: u64 = 0x5EED;

fn curves(scene: &Scene, size: Size, effort: Effort) -> Vec<Curve<'_>> {
    let sides = &[1_u32, 2, 4, 8, 16][..effort.choose(4, 5)];
    let many = effort.choose(32, 64).pow(2) as u32;
    let picture =
        move |sampling, samples, seed| channels(render(scene, size, sampling, samples, seed).ok());
    let reference = picture(Sampling::Stratified, many, REFERENCE);
    let methods = [
        ("random", Sampling::Random),
        ("regular", Sampling::Regular),
        ("stratified", Sampling::Stratified),
    ];
    let curve = |(method, sampling)| {
        let point = |side: &u32| {
            let samples = side * side;
            let image = picture(sampling, samples, 0);
            let errors = image.iter().zip(&reference).map(|(a, b)| a - b);
            let rays = size.pixels() as f64 * f64::from(samples);
            let run = move || render(scene, size, sampling, samples, 0).map_or(0.0, |_| rays);
            Point::new(samples.into(), rays, errors, run)
        };
        Curve::new(method, sides.iter().map(point))
    };
    let asked = [16.0, 8.0, 4.0, 2.0, 1.0, 0.5].map(|levels| levels * HALF_GREY_LEVEL);
    let adaptive = |asked| adaptive(scene, size, asked, &reference);
    let mut curves: Vec<_> = methods.map(curve).into();
    curves.push(Curve::new("adaptive", asked.map(adaptive)));
    curves
}

/// Adaptive sampling, with the requested error as the parameter.
fn adaptive<'a>(scene: &'a Scene, size: Size, asked: f64, reference: &[f64]) -> Point<'a> {
    let render = move || {
        let settings = Settings {
            size,
            samples: 1024,
            max_error: Some(asked),
            ..scene.defaults.clone()
        };
        let sampled = Mutex::new(Sampled::default());
        let image = scene.render(&settings, &sampled).ok();
        let sampled = sampled.into_inner().unwrap_or_else(PoisonError::into_inner);
        (image, sampled.samples as f64)
    };
    let (image, rays) = render();
    let image = channels(image);
    let errors = image.iter().zip(reference).map(|(a, b)| a - b);
    let mean = rays / size.pixels() as f64;
    Point::new(mean, rays, errors, move || render().1)
}

#[cfg(test)]
mod tests {
    use common::Color;

    use super::*;

    /// The brightness of this scene is 1/n with n samples, twice or half of that with other
    /// samplings, and the requested error with adaptive sampling; the reference's is 1/4.
    fn scene() -> Scene {
        let scene = Scene::traced("fading", "", |settings, progress| {
            assert_eq!(settings.size, Size::new(160, 1)?);
            let samples = f64::from(settings.samples);
            let gray = match (settings.max_error, settings.sampling) {
                (Some(asked), _) => {
                    progress.sampled(&Sampled {
                        pixels: 160,
                        samples: 320,
                        most: 2,
                        ..Sampled::default()
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
        let mut curves = (experiment(&scene).unwrap().curves)(Effort::Quick);
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
                assert_eq!([point.knob, point.work, point.rms], expected, "{method}");
            }
        }
        assert_eq!((curves.len(), curves[3].method), (4, "adaptive"));
        for (point, levels) in curves[3].points.iter().zip([16.0, 8.0, 4.0, 2.0, 1.0, 0.5]) {
            assert_eq!([point.knob, point.work], [2.0, 320.0]);
            assert!((point.rms - (0.25 - levels / 510.0)).abs() < 1e-12);
        }
        for point in curves.iter_mut().flat_map(|curve| &mut curve.points) {
            assert_eq!((point.run)(), point.work);
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

    #[test]
    fn a_scene_that_takes_no_samples_is_refused() {
        let scene = Scene::painted("disc", "", |settings, _| Image::black(settings.size));
        let error = experiment(&scene).err().unwrap().to_string();
        assert!(error.starts_with("disc is not sampled"), "{error}");
    }
}
