//! `Ray`: a half line, from its origin in one direction.

use a02_math::{Direction, Point3, Vector3};
use common::ArgumentError;

use crate::BoundedRay;

/// A ray: the points `o + t d`.
///
/// The direction of a ray made by [`Ray::new`] has length 1, so that `t` is the
/// distance from the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    origin: Point3,
    direction: Vector3,
}

impl Ray {
    /// The ray from `origin` in a direction of any length but 0.
    pub fn new(origin: Point3, direction: Vector3) -> Result<Self, ArgumentError> {
        Ok(Self {
            origin: origin.checked("origin")?,
            direction: direction.unit("direction")?,
        })
    }

    /// A ray that is computed from a valid one: a reflected ray, a shadow ray, or
    /// a ray in the space of a transformed object. Nothing is checked, and the
    /// direction keeps its length. It is 1, except in the space of a transformed
    /// object, so that `t` has the same value inside and outside.
    #[must_use]
    pub const fn derived(origin: Point3, direction: Vector3) -> Self {
        Self { origin, direction }
    }

    /// The origin of the ray.
    #[must_use]
    pub const fn origin(&self) -> Point3 {
        self.origin
    }

    /// The direction of the ray.
    #[must_use]
    pub const fn direction(&self) -> Vector3 {
        self.direction
    }

    // ANCHOR: at
    /// The point `o + t d`.
    #[must_use]
    pub fn at(&self, t: f64) -> Point3 {
        self.origin + self.direction * t
    }

    /// The `t` of the ray's nearest point to `point`, which is `point` itself if it
    /// lies on the ray.
    #[must_use]
    pub fn t_of(&self, point: Point3) -> f64 {
        (point - self.origin).dot(self.direction) / self.direction.dot(self.direction)
    }
    // ANCHOR_END: at

    /// The part of the ray up to a distance, which may be infinite.
    pub fn bounded(self, upper_bound: f64) -> Result<BoundedRay, ArgumentError> {
        BoundedRay::new(self, upper_bound)
    }
}
