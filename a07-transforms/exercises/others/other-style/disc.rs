//! `Disc` as a filter of the hits of its plane.

use crate::prelude::*;

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
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let hit = self.plane.hit(ray, within);
        hit.filter(|hit| {
            let [x, y, z] = array(ray.at(hit.t) - self.c);
            (x / self.r).powi(2) + (y / self.r).powi(2) + (z / self.r).powi(2) <= 1.0
        })
    }
}
