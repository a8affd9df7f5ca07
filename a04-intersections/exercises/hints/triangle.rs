//! `Triangle`: three corners.

use crate::prelude::*;

/// A triangle. It has no thickness, and is seen from both sides.
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
    /// The hit, if its `t` lies within the interval, with the normal of length 1 that
    /// points to the side from which a, b and c run counterclockwise. Edges and corners
    /// belong to the triangle.
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let (ab, ac) = (self.b - self.a, self.c - self.a);
        let (d, ao) = (ray.direction(), ray.origin() - self.a);
        let (p, q) = (d.cross(ac), ao.cross(ab));
        let determinant = ab.dot(p);
        let (beta, gamma) = (ao.dot(p) / determinant, d.dot(q) / determinant);
        let t = ac.dot(q) / determinant;
        let is_inside = beta >= 0.0 && gamma >= 0.0 && beta + gamma <= 1.0;
        if !is_inside || !within.contains(t) {
            return None;
        }
        let normal = ab.cross(ac).normalized()?.as_normal();
        Some(Hit::new(t, normal))
    }
}
