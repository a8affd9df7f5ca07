//! `Plane`: flat and infinite.

use crate::prelude::*;

/// The plane through a point, perpendicular to a normal of length 1.
#[derive(Debug)]
pub struct Plane {
    a: Point3,
    n: Normal3,
}

impl Plane {
    /// The plane through `a` with a normal `n` of any length but 0.
    pub fn new(a: Point3, n: Normal3) -> Result<Self, ArgumentError> {
        let n = n.unit("normal n")?;
        Ok(Self { a, n })
    }
}

impl Geometry for Plane {
    /// The hit, if its `t` lies within the interval, with the normal of the plane. The
    /// direction of the ray may have any length.
    ///
    /// `p.dot(q)` is the dot product of vectors and normals, `within.contains(t)` says
    /// whether the hit is valid, and `Hit::new(t, normal)` makes it.
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let to_a = self.a - ray.origin();
        let t = to_a.dot(self.n) / ray.direction().dot(self.n);
        if !within.contains(t) {
            return None;
        }
        Some(Hit::new(t, self.n))
    }
}
