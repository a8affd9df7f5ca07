//! `Disc`: the part of a plane within a radius of a point.
//!
//! Chapter: Transforms, section "Disc". To compare afterwards:
//! `a07-transforms/src/disc.rs`.

use a02_math::{Direction, Normal3, Point3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval, Plane};
use common::ArgumentError;

/// A round, flat disc. It has no thickness, and its rim belongs to it.
#[derive(Debug)]
pub struct Disc {
    plane: Plane,
    c: Point3,
    r: f64,
}

impl Disc {
    pub fn new(c: Point3, n: Normal3, r: f64) -> Result<Self, ArgumentError> {
        Ok(Self {
            plane: Plane::new(c, n)?,
            c,
            r,
        })
    }
}

impl Geometry for Disc {
    /// The hit, if its `t` lies within the interval, with the normal of the plane.
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        testing::missing("the hit within the interval and the radius", None)
    }
}
