//! `Triangle` by Cramer's rule, with four determinants.

use crate::prelude::*;

#[derive(Debug)]
pub struct Triangle {
    a: Point3,
    b: Point3,
    c: Point3,
}

impl Triangle {
    pub fn new(a: Point3, b: Point3, c: Point3) -> Result<Self, ArgumentError> {
        Ok(Self { a, b, c })
    }
}

impl Geometry for Triangle {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let (ab, ac, back) = (self.b - self.a, self.c - self.a, -ray.direction());
        let to_origin = ray.origin() - self.a;
        let whole = determinant(ab, ac, back);
        let beta = determinant(to_origin, ac, back) / whole;
        let gamma = determinant(ab, to_origin, back) / whole;
        let t = determinant(ab, ac, to_origin) / whole;
        let alpha = 1.0 - beta - gamma;
        if alpha >= 0.0 && beta >= 0.0 && gamma >= 0.0 && within.contains(t) {
            return Some(Hit::new(t, ab.cross(ac).normalized()?.as_normal()));
        }
        None
    }
}

fn determinant(a: Vector3, b: Vector3, c: Vector3) -> f64 {
    a.cross(b).dot(c)
}
