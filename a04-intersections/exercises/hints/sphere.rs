//! `Sphere`: all points at the same distance from a centre.

use crate::prelude::*;

/// The sphere around `c` with the radius `r`.
#[derive(Debug)]
pub struct Sphere {
    c: Point3,
    r: f64,
}

impl Sphere {
    pub fn new(c: Point3, r: f64) -> Result<Self, ArgumentError> {
        Ok(Self { c, r })
    }
}

impl Geometry for Sphere {
    /// The nearest hit whose `t` lies within the interval, with the unit normal that
    /// points out of the sphere. The direction of the ray may have any length.
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let (f, d) = (ray.origin() - self.c, ray.direction());
        let a = d.dot(d);
        let middle = -f.dot(d) / a;
        let l = f + d * middle;
        let discriminant = self.r * self.r - l.dot(l);
        if discriminant < 0.0 {
            return None;
        }
        let half = (discriminant / a).sqrt();
        let roots = [middle - half, middle + half];
        let t = roots.into_iter().find(|t| within.contains(*t))?;
        let normal = (f + d * t).normalized()?.as_normal();
        Some(Hit::new(t, normal))
    }
}
