//! `Sphere` by the stable quadratic formula: the root that adds two numbers of the same sign, and the other by the product of both.

use crate::prelude::*;

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
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let (f, d) = (ray.origin() - self.c, ray.direction());
        let (a, b, c) = (d.dot(d), f.dot(d), f.dot(f) - self.r * self.r);
        let discriminant = b * b - a * c;
        if discriminant < 0.0 {
            return None;
        }
        let q = -(b + discriminant.sqrt().copysign(b));
        let mut roots = [q / a, c / q];
        roots.sort_by(f64::total_cmp);
        let t = roots.into_iter().find(|t| within.contains(*t))?;
        let normal = (ray.at(t) - self.c).normalized()?;
        Some(Hit::new(t, normal.as_normal()))
    }
}
