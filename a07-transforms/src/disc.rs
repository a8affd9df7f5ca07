//! `Disc`: the part of a plane within a radius of a point.

use a02_math::{Direction, Normal3, Point3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval, Plane};
use common::{ArgumentError, argument};

/// A round, flat disc. It has no thickness, and its rim belongs to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    pub(crate) plane: Plane,
    pub(crate) c: Point3,
    pub(crate) r: f64,
}

impl Disc {
    /// The disc around `c` with a radius `r` from 1e-100 to 1e100,
    /// perpendicular to a normal `n` of any length but 0.
    pub fn new(c: Point3, n: Normal3, r: f64) -> Result<Self, ArgumentError> {
        Ok(Self {
            plane: Plane::new(c.checked("centre c")?, n)?,
            c,
            r: argument::length("radius r", r)?,
        })
    }
}

/// A hit of the plane at a point `p` with `(p - c) · (p - c) ≤ r²`. Comparing
/// squares avoids a square root, whose rounding would move the rim.
impl Geometry for Disc {
    // ANCHOR: hit
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let hit = self.plane.hit(ray, within)?;
        let from_centre = ray.at(hit.t) - self.c;
        (from_centre.dot(from_centre) <= self.r * self.r).then_some(hit)
    }
    // ANCHOR_END: hit
}
