//! `Edges`: pixels of which the exact mean is known.

use a03_lab::experiments::{experiments, sampled};
use common::{Color, Error, Image, Size};
use measure::experiment::{Curve, Point};
use measure::report::Measured;
use measure::scene_report::MIDDLE;

use super::subject::Subject;

/// An experiment of stage 3.
pub struct Edges {
    name: String,
    methods: Vec<String>,
    measured: Option<Measured<'static>>,
}

impl Edges {
    pub fn named(name: &str, methods: &[&str]) -> Option<Self> {
        experiments().iter().find(|known| known.name == name)?;
        Some(Self {
            name: name.to_owned(),
            methods: methods.iter().map(|name| (*name).to_owned()).collect(),
            measured: None,
        })
    }
}

/// The curve of a method among these. A regular grid of one sample has it in the middle.
fn curve(method: &str, mut curves: Vec<Curve<'static>>) -> Option<Curve<'static>> {
    let is_middle = method == MIDDLE.name;
    let wanted = if is_middle { "regular" } else { method };
    let at = curves.iter().position(|curve| curve.method == wanted)?;
    let mut curve = curves.swap_remove(at);
    if is_middle {
        curve.method = MIDDLE.name;
        curve.points.truncate(1);
    }
    Some(curve)
}

impl Subject for Edges {
    fn work_to_prepare(&self) -> f64 {
        1.0
    }

    fn prepare(&mut self) -> f64 {
        let experiment = experiments()
            .into_iter()
            .find(|known| known.name == self.name);
        if let Some(experiment) = experiment {
            let mut curves = Vec::new();
            for method in &self.methods {
                curves.extend(curve(method, (experiment.curves)()));
            }
            self.measured = Some(Measured { experiment, curves });
        }
        1.0
    }

    fn prepared(&mut self) -> Option<Measured<'static>> {
        self.measured.take()
    }

    /// Short runs are repeated until they take as long as others.
    fn work(&self, _: &Point) -> f64 {
        1.0
    }

    fn picture(&self, method: &str, point: usize) -> Result<(Image, Vec<f64>), Error> {
        let missing = || Error::Usage(format!("no picture of {method}"));
        let method = if method == MIDDLE.name {
            "regular"
        } else {
            method
        };
        let samples = 4_u32.pow(point as u32);
        let sampled = sampled(&self.name, method, samples).ok_or_else(missing)?;
        // A single column of pixels is shown as several.
        let width = if sampled.width == 1 {
            40
        } else {
            sampled.width
        };
        let size = Size::new(width, sampled.lights.len() as u32 / width)?;
        let at = |x: u32, y: u32| (y * width + x) as usize;
        let image = Image::from_fn(size, |x, y| Color::gray(sampled.lights[at(x, y)]))?;
        let mut errors = Vec::new();
        for (light, mean) in sampled.lights.iter().zip(&sampled.means) {
            errors.extend([light - mean; 3]);
        }
        Ok((image, errors))
    }
}
