//! `Trial`: a picture by adaptive sampling beside its true error.

use std::sync::{Mutex, PoisonError};

use common::{Color, Error, Image, Sampled, Settings, Size};
use engine::adaptive::render_image;
use engine::camera_place;
use rayon::iter::{IntoParallelIterator, ParallelIterator};

use crate::kinds::{Kind, Light, Numbers};
use crate::random::PixelRandom;

/// A variant of a kind at a size, with two independent pictures of many samples.
pub struct Subject {
    light: Light,
    size: Size,
    references: [Vec<Color>; 2],
}

/// What came of one rendering.
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
        let references = [1, 2].map(|seed| stratified(&light, size, side, seed));
        Self {
            light,
            size,
            references,
        }
    }

    /// The root mean square error of some pixels. The product of the differences from two
    /// independent references has no share of their noise, on average.
    fn error(&self, pixels: &[Color]) -> f64 {
        let [first, second] = &self.references;
        let products = pixels.iter().zip(first).zip(second).map(|((pixel, a), b)| {
            let (a, b) = (*a - shown(*pixel), *b - shown(*pixel));
            a.r * b.r + a.g * b.g + a.b * b.b
        });
        let sum: f64 = products.sum();
        (sum.max(0.0) / (3 * pixels.len()) as f64).sqrt()
    }

    /// The errors of stratified sampling, for numbers of samples.
    pub fn uniform(&self) -> Vec<(f64, f64)> {
        let sides = [1, 2, 3, 4, 6, 9, 13].into_iter();
        let error = |side| self.error(&stratified(&self.light, self.size, side, 3));
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
        let image: Image = render_image(bound, light, &settings, &sampled)?;
        let sampled = sampled.into_inner().unwrap_or_else(PoisonError::into_inner);
        let error = self.error(image.pixels());
        Ok(Trial {
            error: error / bound,
            is_said: sampled.misses(Some(bound)),
            samples: sampled.samples as f64 / sampled.pixels as f64,
            uniform: samples_for(error, uniform),
        })
    }
}

/// The samples per pixel for an error, between the measured ones as a power law, and beyond
/// the last with the exponent of theory, -3/4.
fn samples_for(error: f64, uniform: &[(f64, f64)]) -> f64 {
    let enough = uniform.iter().position(|(_, of)| *of <= error);
    match (enough, uniform) {
        (Some(0), _) | (_, []) => 1.0,
        (Some(i), _) => {
            let ((fewer, above), (more, below)) = (uniform[i - 1], uniform[i]);
            let share = libm::log(above / error) / libm::log(above / below.max(1e-12));
            fewer * libm::pow(more / fewer, share)
        }
        (None, [.., (samples, last)]) => samples * libm::pow(last / error, 4.0 / 3.0),
    }
}

fn shown(color: Color) -> Color {
    color.map(|channel| channel.clamp(0.0, 1.0))
}

/// The light at a place in the coordinates of the camera.
fn look(light: &Light, size: Size, x: f64, y: f64) -> Color {
    let width = f64::from(size.width());
    light((x + 0.5) / width, (y + 0.5) / width)
}

/// The pixels with `side` x `side` stratified samples each.
fn stratified(light: &Light, size: Size, side: u32, seed: u64) -> Vec<Color> {
    let pixel = |i| {
        let (column, row) = (i % size.width(), i / size.width());
        let random = PixelRandom::new(0x5EED + seed, column, row);
        let mut sum = Color::BLACK;
        for i in 0..side * side {
            let in_cell = |cell: u32, n| (f64::from(cell) + random.uniform(n)) / f64::from(side);
            let n = 2 * u64::from(i);
            let place = (in_cell(i % side, n), in_cell(i / side, n + 1));
            let (x, y) = camera_place(size, (column, row), place);
            sum += look(light, size, x, y);
        }
        shown(sum * (1.0 / f64::from(side * side)))
    };
    let pixels = 0..size.width() * size.height();
    pixels.into_par_iter().map(pixel).collect()
}
