//! `Pictures`: the samples of a scene.

use common::{Error, Scene};
use measure::experiment::Curve;
use measure::report::Measured;
use measure::scene_report::{
    METHODS, MIDDLE, Method, REFERENCES, Reference, Samples, without_curves,
};

use super::Shown;
use crate::catalogue;

/// The measurement of a scene.
pub struct Pictures {
    samples: Samples<'static>,
    methods: Vec<Method>,
    references: Vec<Vec<f64>>,
    reference: Option<Reference>,
    /// Of each method, as far as it is measured.
    curves: Vec<Curve<'static>>,
}

/// The work of a reference picture, in samples per pixel of the lesson, of which the engine does three at
/// the time of one.
const REFERENCE_WORK: f64 = 1024.0 / 3.0;

/// The work of a method at one of its values. An error of adaptive sampling, in half grey levels, has about the size of
/// its work.
const fn work(value: f64) -> f64 {
    value + 1.0
}

impl Pictures {
    pub fn new(name: &str, methods: &[&str]) -> Result<Self, Error> {
        // A measurement borrows it until the page stops this module.
        let scene: &'static Scene = Box::leak(Box::new(catalogue::scene(name)?));
        let known = [MIDDLE].into_iter().chain(METHODS);
        let methods: Vec<_> = known
            .filter(|method| methods.contains(&method.name))
            .collect();
        Ok(Self {
            samples: Samples::new(scene)?,
            references: Vec::new(),
            reference: None,
            curves: methods
                .iter()
                .map(|method| Curve::new(method.name, []))
                .collect(),
            methods,
        })
    }

    /// The amount of work before the first turn, in samples per pixel.
    pub fn work_to_prepare(&self) -> f64 {
        REFERENCES.len() as f64 * REFERENCE_WORK + self.work_of_a_round()
    }

    /// That of one turn of every point.
    pub fn work_of_a_round(&self) -> f64 {
        let values = self.methods.iter().flat_map(|method| method.values);
        values.map(|value| work(*value)).sum()
    }

    /// That of one turn of a point.
    pub fn work(&self, curve: usize, point: usize) -> f64 {
        work(self.methods[curve].values[point])
    }

    /// Renders the next picture, and returns its work.
    pub fn prepare(&mut self) -> f64 {
        if let Some(seed) = REFERENCES.get(self.references.len()) {
            self.references.push(self.samples.reference_picture(*seed));
            return REFERENCE_WORK;
        }
        let references = &self.references;
        let reference = self
            .reference
            .get_or_insert_with(|| Reference::of(&references[0], &references[1]));
        for (method, curve) in self.methods.iter().zip(&mut self.curves) {
            if let Some(value) = method.values.get(curve.points.len()) {
                let point = self.samples.point(*method, *value, reference);
                curve.points.push(point);
                return work(*value);
            }
        }
        0.0
    }

    /// The experiment, once all pictures are rendered.
    pub fn measured(&mut self) -> Option<Measured<'static>> {
        let mut pairs = self.methods.iter().zip(&self.curves);
        let is_ready = pairs.all(|(method, curve)| curve.points.len() == method.values.len());
        is_ready.then(|| Measured {
            experiment: without_curves("samples"),
            curves: std::mem::take(&mut self.curves),
        })
    }

    /// The picture of a method's point.
    pub fn picture(&self, method: &str, point: usize) -> Result<Shown, Error> {
        let missing = || Error::Usage(format!("no picture of {method}"));
        let method = self.methods.iter().find(|known| known.name == method);
        let value = method.and_then(|method| method.values.get(point));
        let (method, value) = method.zip(value).ok_or_else(missing)?;
        let reference = self.reference.as_ref().ok_or_else(missing)?;
        let image = self.samples.picture(*method, *value);
        let errors = reference.differences(&image);
        Ok(Shown {
            image: image?,
            errors,
        })
    }
}
