//! `Plane` by the height of the origin and its loss in a step; a parallel ray is a case of its own.

use crate::prelude::*;

#[derive(Debug)]
pub struct Plane {
    a: Point3,
    n: Normal3,
}

impl Plane {
    pub fn new(a: Point3, n: Normal3) -> Result<Self, ArgumentError> {
        Ok(Self {
            a,
            n: n.unit("normal n")?,
        })
    }
}

impl Geometry for Plane {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let height = (ray.origin() - self.a).dot(self.n);
        let loss = -ray.direction().dot(self.n);
        if loss == 0.0 {
            return None;
        }
        let t = height / loss;
        if within.min < t && t < within.max {
            Some(Hit::new(t, self.n))
        } else {
            None
        }
    }
}
