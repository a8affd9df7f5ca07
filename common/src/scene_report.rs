//! What samples are worth for one scene, so that a person can choose how many
//! to pay for.

use std::sync::{Mutex, PoisonError};

use crate::experiment::{Axis, Curve, Experiment, HALF_GREY_LEVEL, Point};
use crate::{Effort, Error, Image, Sampled, Sampling, Scene, Settings, Size};

/// Samples per pixel and their places, against many samples of another seed.
pub(crate) fn experiment(scene: &Scene) -> Result<Experiment<'_>, Error> {
    if !scene.heeds.sampling {
        let name = scene.name;
        return Err(Error::Usage(format!(
            "{name} is not sampled: there is nothing to choose"
        )));
    }
    // What can fail does so here; more samples do not change that.
    let size = small(scene.defaults.size)?;
    render(scene, size, Sampling::Center, 1, 0)?;
    Ok(Experiment {
        name: scene.name,
        about: "what do more samples buy, and where should they lie?",
        knob: "samples",
        work: "rays",
        error: "of a channel from 0 to 1, against many samples of another seed",
        against: Axis::Work,
        curves: Box::new(move |effort| curves(scene, size, effort)),
    })
}

/// The same shape of picture, 160 pixels wide.
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

/// The channels as a screen shows them.
fn channels(image: Option<Image>) -> Vec<f64> {
    let pixels = image.map_or(Vec::new(), |image| image.pixels().to_vec());
    let shown = |color: crate::Color| color.map(|c| c.clamp(0.0, 1.0)).channels();
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
    let curve = |(method, sampling)| Curve {
        method,
        remark: "",
        slope: None,
        points: sides
            .iter()
            .map(|side| {
                let samples = side * side;
                let image = picture(sampling, samples, 0);
                let errors = image.iter().zip(&reference).map(|(a, b)| a - b);
                let rays = size.pixels() as f64 * f64::from(samples);
                let run = move || render(scene, size, sampling, samples, 0).map_or(0.0, |_| rays);
                Point::new(samples.into(), rays, errors, run)
            })
            .collect(),
    };
    let mut curves: Vec<_> = methods.map(curve).into();
    let asked = [16.0, 8.0, 4.0, 2.0, 1.0, 0.5].map(|levels| levels * HALF_GREY_LEVEL);
    let points = asked
        .iter()
        .map(|asked| adaptive(scene, size, *asked, &reference));
    curves.push(Curve {
        method: "adaptive",
        remark: "",
        slope: None,
        points: points.collect(),
    });
    curves
}

/// As many samples as it takes for the error that is asked for.
fn adaptive<'a>(scene: &'a Scene, size: Size, asked: f64, reference: &[f64]) -> Point<'a> {
    let render = move || {
        let settings = Settings {
            size,
            samples: 1024,
            max_error: Some(asked),
            ..scene.defaults.clone()
        };
        let told = Mutex::new(Sampled::default());
        let image = scene.render(&settings, &told).ok();
        let told = told.into_inner().unwrap_or_else(PoisonError::into_inner);
        (image, told.samples as f64)
    };
    let (image, rays) = render();
    let image = channels(image);
    let errors = image.iter().zip(reference).map(|(a, b)| a - b);
    let mean = rays / size.pixels() as f64;
    Point::new(mean, rays, errors, move || render().1)
}
