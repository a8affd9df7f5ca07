//! `Sphere` by the formula for an even coefficient, (-b ± √(b² - ac)) / a, with the normal (p - c) / r.

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
        let (a, b) = (d.dot(d), f.dot(d));
        let discriminant = b * b - a * (f.dot(f) - self.r * self.r);
        if discriminant < 0.0 {
            return None;
        }
        let root = discriminant.sqrt();
        let mut t = (-b - root) / a;
        if !within.contains(t) {
            t = (-b + root) / a;
        }
        if !within.contains(t) {
            return None;
        }
        let normal = (ray.at(t) - self.c) * (1.0 / self.r);
        Some(Hit::new(t, normal.as_normal()))
    }
}
