//! `Subject`: what is measured on the page, an experiment with edges or a picture.

use common::{Error, Image};
use measure::experiment::Point;
use measure::report::Measured;

use super::edges::Edges;
use super::pictures::Pictures;

/// Prepares the errors of some methods in steps, and shows the pictures behind their points.
pub trait Subject {
    /// The amount of work before the first turn; that of a turn is the `work` of its point.
    fn work_to_prepare(&self) -> f64;

    /// Does a step, and returns its work.
    fn prepare(&mut self) -> f64;

    /// The experiment, once everything is prepared; it is given away.
    fn prepared(&mut self) -> Option<Measured<'static>>;

    /// The work of a turn of a point.
    fn work(&self, point: &Point) -> f64;

    /// The picture of a method's point, and by how much its channels are too bright.
    fn picture(&self, method: &str, point: usize) -> Result<(Image, Vec<f64>), Error>;
}

/// The experiment with edges of this name, or the samples of a picture.
pub fn named(name: &str, methods: &[&str]) -> Result<Box<dyn Subject>, Error> {
    match Edges::named(name, methods) {
        Some(edges) => Ok(Box::new(edges)),
        None => Ok(Box::new(Pictures::new(name, methods)?)),
    }
}
