//! Error against work: methods to place the samples in a pixel.
//!
//! All samplers are tested on two kinds of pixels, because positions that are
//! good for one kind may be poor for another. Every pixel's mean has a closed
//! form, so no reference picture with more samples is needed.

mod coverage;
mod places;

use measure::experiment::{Curve, Errors, Experiment, Point, Slope, Times};

use coverage::{disc_coverage, in_disc, in_stripe, stripes};
use places::{METHODS, Places};

const EDGES: [TestPattern; 2] = [CURVED_EDGE, LEVEL_EDGE];

/// All experiments of the stage.
pub fn experiments() -> Vec<Experiment<'static>> {
    EDGES.map(TestPattern::experiment).into()
}

/// The light of the pixels of an experiment, row by row from the top.
pub struct Sampled {
    /// Pixels in a row.
    pub width: u32,
    /// By some samples in each pixel that an edge crosses.
    pub lights: Vec<f64>,
    /// In closed form.
    pub means: Vec<f64>,
}

/// The picture behind a point of an experiment; none if there is no method or experiment of this name.
pub fn sampled(experiment: &str, method: &str, samples: u32) -> Option<Sampled> {
    let picture = EDGES.iter().find(|picture| picture.name == experiment)?;
    let method = METHODS.iter().find(|known| known.name == method)?;
    let (mut lights, mut means) = (Vec::new(), Vec::new());
    for row in (0..picture.height).rev() {
        for column in 0..picture.width {
            let mean = (picture.mean)(column.into(), row.into());
            let pixel = Pixel { column, row, mean };
            lights.push(if pixel.is_crossed() {
                picture.sampled_mean(&pixel, method.places, samples)
            } else {
                mean
            });
            means.push(mean);
        }
    }
    Some(Sampled {
        width: picture.width,
        lights,
        means,
    })
}

/// A picture whose pixels have known means, and the question that it answers.
#[derive(Clone, Copy)]
struct TestPattern {
    name: &'static str,
    question: &'static str,
    /// The light at a position, from 0 to 1. Lengths are in pixels.
    light: fn(f64, f64) -> f64,
    /// The mean over the pixel whose lower left corner has these coordinates.
    mean: fn(f64, f64) -> f64,
    width: u32,
    height: u32,
    /// The slopes of the errors of [`METHODS`], in their order, where theory gives one.
    slopes: [Option<f64>; METHODS.len()],
}

/// Slopes at curved edges: Mitchell, Consequences of Stratified Sampling in Graphics, 1996.
const CURVED_EDGE: TestPattern = TestPattern {
    name: "samples-curved-edge",
    question: "Where should samples lie in a pixel that a disc's edge crosses?",
    light: |x, y| if in_disc(x, y) { 1.0 } else { 0.0 },
    mean: disc_coverage,
    width: 64,
    height: 64,
    slopes: [Some(-0.5), Some(-0.75), Some(-0.75), Some(-0.5), None],
};

/// At level edges, a regular grid of n samples has only sqrt(n) heights, and n rooks have n.
const LEVEL_EDGE: TestPattern = TestPattern {
    name: "samples-level-edge",
    question: "Where should samples lie in a pixel that a level edge crosses?",
    light: |_, y| if in_stripe(y) { 1.0 } else { 0.0 },
    mean: |_, y| stripes(y),
    width: 1,
    height: 1000,
    slopes: [Some(-0.5), Some(-0.5), Some(-0.75), Some(-1.0), None],
};

/// A pixel, and its exact mean.
struct Pixel {
    column: u32,
    row: u32,
    mean: f64,
}

impl Pixel {
    /// Whether its light is not the same everywhere.
    fn is_crossed(&self) -> bool {
        (1e-9..1.0 - 1e-9).contains(&self.mean)
    }
}

impl TestPattern {
    /// An experiment with all samplers.
    fn experiment(self) -> Experiment<'static> {
        Experiment {
            question: self.question,
            parameter: "samples per pixel",
            work: "rays per pixel",
            error: "rms error of a pixel",
            exact: "against the pixel's mean in closed form",
            seeds: &[0, 1, 2],
            curves: Box::new(move || self.curves()),
            ..Experiment::new(self.name)
        }
    }

    fn curves(self) -> Vec<Curve<'static>> {
        let mut curves = Vec::new();
        for (method, slope) in METHODS.iter().zip(self.slopes) {
            let mut points = Vec::new();
            for count in [1, 4, 16, 64, 256, 1024] {
                points.push(self.point(method.places, count));
            }
            curves.push(Curve {
                slope: slope.map(|value| Slope {
                    value,
                    between: 16.0..=1024.0,
                }),
                ..Curve::new(method.name, points)
            });
        }
        curves
    }

    /// The pixels that are not constant.
    fn pixels(&self) -> Vec<Pixel> {
        let mut pixels = Vec::new();
        for row in 0..self.height {
            for column in 0..self.width {
                let mean = (self.mean)(column.into(), row.into());
                pixels.extend(Some(Pixel { column, row, mean }).filter(Pixel::is_crossed));
            }
        }
        pixels
    }

    /// The mean of the light at some positions in a pixel.
    fn sampled_mean(&self, pixel: &Pixel, places: Places, count: u32) -> f64 {
        let (left, bottom) = (f64::from(pixel.column), f64::from(pixel.row));
        let mut sum = 0.0;
        for (dx, dy) in places(pixel.column, pixel.row, count) {
            sum += (self.light)(left + dx, bottom + dy);
        }
        sum / f64::from(count)
    }

    /// The measurement of a method with a number of samples for each pixel.
    fn point(self, places: Places, count: u32) -> Point<'static> {
        let pixels = self.pixels();
        let mut errors = Vec::new();
        for pixel in &pixels {
            errors.push(self.sampled_mean(pixel, places, count) - pixel.mean);
        }
        Point {
            parameter: count.into(),
            work: count.into(),
            errors: Errors::of(errors),
            times: Times::of(move || {
                let means = pixels
                    .iter()
                    .map(|pixel| self.sampled_mean(pixel, places, count));
                means.sum::<f64>()
            }),
        }
    }
}
