//! `Light`: the light that a source sends to a point.

use std::any::Any;
use std::fmt::Debug;

use a02_math::{Point3, Vector3};
use common::Color;

/// The light that a source sends to a point, without objects in between.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
// ANCHOR: illumination
pub struct Illumination {
    /// The colour of the light.
    pub color: Color,
    /// Direction from the point to the source, of length 1.
    pub direction: Vector3,
    /// Distance from the point to the source; infinite for a directional light.
    pub distance: f64,
}
// ANCHOR_END: illumination

/// A source of light.
pub trait Light: Any + Debug + Send + Sync {
    /// The light that arrives at `point`, or `None` if the point lies outside of
    /// the beam or in the source itself.
    fn illumination(&self, point: Point3) -> Option<Illumination>;

    /// Whether the light shines on `point`, without objects in between.
    fn illuminates(&self, point: Point3) -> bool {
        self.illumination(point).is_some()
    }

    /// The direction of length 1 from `point` to the light, if it shines there.
    fn direction_from(&self, point: Point3) -> Option<Vector3> {
        self.illumination(point).map(|light| light.direction)
    }
}
