//! `Disc` with a plane of its own, and the distance from the centre.

use crate::prelude::*;

#[derive(Debug)]
pub struct Disc {
    c: Point3,
    n: Normal3,
    r: f64,
}

impl Disc {
    pub fn new(c: Point3, n: Normal3, r: f64) -> Result<Self, ArgumentError> {
        Ok(Self {
            c,
            n: n.unit("normal n")?,
            r,
        })
    }
}

impl Geometry for Disc {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let t = (self.c - ray.origin()).dot(self.n) / ray.direction().dot(self.n);
        let is_within = within.contains(t) && (ray.at(t) - self.c).magnitude() <= self.r;
        is_within.then(|| Hit::new(t, self.n))
    }
}
