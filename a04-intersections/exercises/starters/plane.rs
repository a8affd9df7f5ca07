//! `Plane`: flat and infinite.
//!
//! Chapter: Intersections, section "Plane". To compare afterwards:
//! `a04-intersections/src/plane.rs`.

use a02_math::{Direction, Normal3, Point3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval};
use common::ArgumentError;

/// The plane through a point, perpendicular to a normal.
#[derive(Debug)]
pub struct Plane {
    a: Point3,
    /// Of length 1.
    n: Normal3,
}

impl Plane {
    /// The plane through `a` with a normal `n` of any length but 0.
    pub fn new(a: Point3, n: Normal3) -> Result<Self, ArgumentError> {
        Ok(Self {
            a,
            n: n.unit("normal n")?,
        })
    }
}

impl Geometry for Plane {
    /// The hit, if its `t` lies within the interval, with the normal of the plane. The
    /// direction of the ray may have any length.
    ///
    /// `p.dot(q)` is the dot product of vectors and normals, `within.contains(t)` says
    /// whether the hit is valid, and `Hit::new(t, normal)` makes it.
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        testing::missing("the hit within the interval", None)
    }
}
