//! `Triangle` as a part of its plane: the hit lies to the left of each edge.

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
        let n = (self.b - self.a).cross(self.c - self.a).normalized()?;
        let t = (self.a - ray.origin()).dot(n) / ray.direction().dot(n);
        if !within.contains(t) {
            return None;
        }
        let p = ray.at(t);
        for (from, to) in [(self.a, self.b), (self.b, self.c), (self.c, self.a)] {
            if (to - from).cross(p - from).dot(n) < 0.0 {
                return None;
            }
        }
        Some(Hit::new(t, n.as_normal()))
    }
}
