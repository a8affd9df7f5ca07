//! `Sphere` by the quadratic formula of school, (-b ± √(b² - 4ac)) / 2a.

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
        let a = d.dot(d);
        let b = 2.0 * f.dot(d);
        let c = f.dot(f) - self.r * self.r;
        let discriminant = b * b - 4.0 * a * c;
        if discriminant < 0.0 {
            return None;
        }
        let root = discriminant.sqrt();
        for t in [(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)] {
            if within.contains(t) {
                let normal = (ray.at(t) - self.c).normalized()?;
                return Some(Hit::new(t, normal.as_normal()));
            }
        }
        None
    }
}
