//! `Plane` as n · p = k.

use crate::prelude::*;

#[derive(Debug)]
pub struct Plane {
    k: f64,
    n: Normal3,
}

impl Plane {
    pub fn new(a: Point3, n: Normal3) -> Result<Self, ArgumentError> {
        let n = n.unit("normal n")?;
        Ok(Self {
            k: n.dot(a - Point3::ORIGIN),
            n,
        })
    }
}

impl Geometry for Plane {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let t = (self.k - self.n.dot(ray.origin() - Point3::ORIGIN)) / self.n.dot(ray.direction());
        within.contains(t).then(|| Hit::new(t, self.n))
    }
}
