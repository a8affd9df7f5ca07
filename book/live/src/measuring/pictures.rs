//! `Pictures`: the samples of a scene.

use common::{Color, Error, Image, Scene, Size};
use measure::experiment::{Curve, Point};
use measure::report::Measured;
use measure::scene_report::{
    METHODS, MIDDLE, Method, REFERENCES, Reference, Samples, without_curves,
};

use super::subject::Subject;
use crate::{Answered, catalogue};

/// The measurement of a scene.
pub struct Pictures {
    samples: Samples<'static>,
    methods: Vec<Method>,
    references: Vec<Vec<f64>>,
    reference: Option<Reference>,
    curves: Vec<Curve<'static>>,
    is_given_away: bool,
}

/// The work of a reference picture, in samples per pixel of the lesson, of which the engine does three at
/// the time of one.
const REFERENCE_WORK: f64 = 1024.0 / 3.0;

impl Pictures {
    pub fn new(name: &str, methods: &[&str]) -> Result<Self, Error> {
        // A measurement borrows it until the page stops this module.
        let scene: &'static Scene = Box::leak(Box::new(catalogue::scene(name)?));
        let known = [MIDDLE].into_iter().chain(METHODS);
        let methods = known.filter(|method| methods.contains(&method.name));
        Ok(Self {
            samples: Samples::new(scene)?,
            methods: methods.collect(),
            references: Vec::new(),
            reference: None,
            curves: Vec::new(),
            is_given_away: false,
        })
    }
}

impl Subject for Pictures {
    fn work_to_prepare(&self) -> f64 {
        let points = self.methods.iter().flat_map(|method| method.values);
        2.0 * REFERENCE_WORK + points.map(|value| value + 1.0).sum::<f64>()
    }

    fn prepare(&mut self) -> f64 {
        let done = self.references.len();
        if let Some(seed) = REFERENCES.get(done) {
            self.references.push(self.samples.reference_picture(*seed));
            return REFERENCE_WORK;
        }
        let references = &self.references;
        let reference = self
            .reference
            .get_or_insert_with(|| Reference::of(&references[0], &references[1]));
        for method in &self.methods {
            let at = self
                .curves
                .iter()
                .position(|curve| curve.method == method.name);
            let at = at.unwrap_or_else(|| {
                self.curves.push(Curve::new(method.name, []));
                self.curves.len() - 1
            });
            let points = &mut self.curves[at].points;
            if let Some(value) = method.values.get(points.len()) {
                points.push(self.samples.point(*method, *value, reference));
                return value + 1.0;
            }
        }
        0.0
    }

    fn prepared(&mut self) -> Option<Measured<'static>> {
        let points: usize = self.curves.iter().map(|curve| curve.points.len()).sum();
        let all: usize = self.methods.iter().map(|method| method.values.len()).sum();
        if points < all || self.is_given_away {
            return None;
        }
        self.is_given_away = true;
        Some(Measured {
            experiment: without_curves("samples"),
            curves: std::mem::take(&mut self.curves),
        })
    }

    fn work(&self, point: &Point) -> f64 {
        point.parameter + 1.0
    }

    fn picture(&self, method: &str, point: usize) -> Result<(Image, Vec<f64>), Error> {
        let missing = || Error::Usage(format!("no picture of {method}"));
        let method = self.methods.iter().find(|known| known.name == method);
        let value = method.and_then(|method| method.values.get(point));
        let (method, value) = method.zip(value).ok_or_else(missing)?;
        let reference = self.reference.as_ref().ok_or_else(missing)?;
        let image = self.samples.picture(*method, *value);
        let errors = reference.differences(&image);
        Ok((image?, errors))
    }
}

/// A picture, and beside it how far each channel is off: grey is right, lighter is too bright. The errors
/// are enlarged by a power of two that makes their root mean square an eighth or more.
pub fn beside(picture: &Image, errors: &[f64], rms: f64) -> Answered {
    let factor = if rms > 0.0 {
        libm::exp2(libm::ceil(libm::log2(0.125 / rms))).max(1.0)
    } else {
        1.0
    };
    let (width, height) = (picture.size().width(), picture.size().height());
    let enlarged = Image::from_fn(picture.size(), |x, y| {
        let pixel = 3 * (y * width + x) as usize;
        let [r, g, b] = [0, 1, 2].map(|channel| 0.5 + factor * errors[pixel + channel]);
        Color::new(r, g, b)
    })?;
    let mut both = Image::black(Size::new(2 * width, height)?)?;
    both.paste(0, 0, picture);
    both.paste(width, 0, &enlarged);
    Ok(crate::picture::pixels(&both).with("factor", [factor]))
}
