//! `Trial`: a picture by adaptive sampling beside its true error.

use std::sync::{Mutex, PoisonError};

use common::{Color, Error, Image, Sampled, Settings, Size};
use engine::adaptive::render_image;

use crate::kinds::{Kind, Light, Numbers};
use crate::stratified::{shown, stratified};

/// A variant of a kind at a size, with two independent pictures of many samples.
pub struct Subject {
    light: Light,
    size: Size,
    references: [Image; 2],
}

/// The result of one rendering.
pub struct Trial {
    /// The true root mean square error, as a share of the bound.
    pub error: f64,
    /// Whether the report says that the error may be above the bound.
    pub is_said: bool,
    /// Samples per pixel, and those that stratified sampling of all pixels takes to the same
    /// true error.
    pub samples: f64,
    pub uniform: f64,
}

impl Trial {
    /// Whether the error is above the bound, and nothing says so.
    pub fn is_silent(&self) -> bool {
        self.error > 1.0 && !self.is_said
    }
}

impl Subject {
    /// With 2 x `side` x `side` stratified samples a pixel.
    pub fn new(kind: &Kind, variant: u32, size: Size, side: u32) -> Self {
        let light = (kind.make)(Numbers::new(kind.name, variant));
        let look = |x, y| look(&light, size, x, y);
        let references = [1, 2].map(|seed| stratified(look, size, side, seed));
        Self {
            light,
            size,
            references,
        }
    }

    /// The mean square error of a picture. The product of the differences from two
    /// independent references has no share of their noise, on average.
    fn square_error(&self, image: &Image) -> f64 {
        let [first, second] = self.references.each_ref().map(Image::pixels);
        let pixels = image.pixels().iter().zip(first).zip(second);
        let products = pixels.map(|((pixel, a), b)| {
            let (a, b) = (*a - shown(*pixel), *b - shown(*pixel));
            a.r * b.r + a.g * b.g + a.b * b.b
        });
        products.sum::<f64>().max(0.0) / (3 * first.len()) as f64
    }

    /// The root mean square errors of stratified sampling, for numbers of samples. Where
    /// few samples leave much to chance, it is the mean of several pictures.
    pub fn uniform(&self) -> Vec<(f64, f64)> {
        let sides = [1, 2, 3, 4, 6, 9, 13, 19].into_iter();
        let error = |side: u32| {
            let pictures = (16 / side).clamp(1, 4);
            let errors = (3..3 + u64::from(pictures)).map(|seed| {
                let look = |x, y| look(&self.light, self.size, x, y);
                self.square_error(&stratified(look, self.size, side, seed))
            });
            (errors.sum::<f64>() / f64::from(pictures)).sqrt()
        };
        sides
            .map(|side| (f64::from(side * side), error(side)))
            .collect()
    }

    /// Renders the picture with this bound.
    pub fn trial(&self, bound: f64, seed: u64, uniform: &[(f64, f64)]) -> Result<Trial, Error> {
        let settings = Settings {
            size: self.size,
            samples: 1024,
            max_error: Some(bound),
            seed,
            ..Settings::default()
        };
        let sampled = Mutex::new(Sampled::default());
        let light = |x, y| look(&self.light, self.size, x, y);
        let image: Image = render_image(bound, &light, &settings, &sampled)?;
        let sampled = sampled.into_inner().unwrap_or_else(PoisonError::into_inner);
        let error = self.square_error(&image).sqrt();
        Ok(Trial {
            error: error / bound,
            is_said: sampled.misses(Some(bound)),
            samples: sampled.samples as f64 / sampled.pixels as f64,
            uniform: samples_for(error, uniform),
        })
    }
}

/// The samples per pixel for an error, between the measured ones as a power law, and beyond
/// the last with the exponent of theory, -3/4, or the measured one if the error falls faster.
fn samples_for(error: f64, uniform: &[(f64, f64)]) -> f64 {
    let enough = uniform.iter().position(|(_, of)| *of <= error);
    let last = uniform.len().saturating_sub(1);
    let end = enough.unwrap_or(last);
    if end == 0 || uniform.is_empty() {
        return 1.0;
    }
    let ((fewer, above), (more, below)) = (uniform[end - 1], uniform[end]);
    let exponent = libm::log(above / below.max(1e-12)) / libm::log(more / fewer);
    let exponent = if enough.is_some() {
        exponent
    } else {
        exponent.max(0.75)
    };
    more * libm::pow(below / error, 1.0 / exponent)
}

/// The light at a place in the coordinates of the camera.
fn look(light: &Light, size: Size, x: f64, y: f64) -> Color {
    let width = f64::from(size.width());
    light((x + 0.5) / width, (y + 0.5) / width)
}
