//! `BoundedRay`: the second course's ray, which ends.

use a02_math::Point3;
use common::{ArgumentError, argument};

use crate::Ray;

/// The points of a ray from its origin up to a greatest `t`, both included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoundedRay {
    ray: Ray,
    upper_bound: f64,
}

impl BoundedRay {
    /// `ray` up to `t = upper_bound`, which is at least 0 and may be infinite.
    pub fn new(ray: Ray, upper_bound: f64) -> Result<Self, ArgumentError> {
        // NaN is not at least 0 either.
        let valid = upper_bound >= 0.0;
        argument::check("upper bound", upper_bound, valid, "at least 0, or infinite")?;
        Ok(Self { ray, upper_bound })
    }

    /// The point at distance `t`, or `None` if `t` is negative or beyond the bound.
    #[must_use]
    pub fn at(&self, t: f64) -> Option<Point3> {
        (0.0..=self.upper_bound)
            .contains(&t)
            .then(|| self.ray.at(t))
    }
}
