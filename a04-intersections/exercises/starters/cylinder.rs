//! `Cylinder`: a tube around the y axis.

use a02_math::Normal3;
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval};
use common::{ArgumentError, argument};

/// A tube around the y axis, from `y = 0` up to its height, open at both ends.
#[derive(Clone, Copy, Debug)]
pub struct Cylinder {
    r: f64,
    height: f64,
}

impl Cylinder {
    /// The tube of a radius `r` and a height.
    pub fn new(r: f64, height: f64) -> Result<Self, ArgumentError> {
        Ok(Self {
            r: argument::length("radius r", r)?,
            height: argument::length("height", height)?,
        })
    }
}

impl Geometry for Cylinder {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let (o, d) = (ray.origin(), ray.direction());
        let crossings = testing::missing("where the ray crosses the wall", [f64::NAN; 2]);

        testing::missing("the crossing that counts, and the normal there", None)
    }
}
