//! `Disc`: the part of a plane within a radius of a point.

use crate::prelude::*;

/// A round, flat disc. It has no thickness, and its rim belongs to it.
#[derive(Debug)]
pub struct Disc {
    plane: Plane,
    c: Point3,
    r: f64,
}

impl Disc {
    pub fn new(c: Point3, n: Normal3, r: f64) -> Result<Self, ArgumentError> {
        let plane = Plane::new(c, n)?;
        Ok(Self { plane, c, r })
    }
}

impl Geometry for Disc {
    /// The hit, if its `t` lies within the interval, with the normal of the plane.
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let hit = self.plane.hit(ray, within)?;
        let from_centre = ray.at(hit.t) - self.c;
        let is_within = from_centre.dot(from_centre) <= self.r * self.r;
        is_within.then_some(hit)
    }
}
