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
    ///
    /// A ray has `origin()` and `direction()`; `a.dot(b)` and `a.cross(b)` are the products of vectors.
    /// `within.contains(t)` says whether the hit is valid, `Hit::new(t, normal)` makes it, and
    /// `vector.normalized()?.as_normal()` is a normal of length 1.
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        // 1. Express the hit by a and fractions of the edges to b and c: three equations.
        // 2. Solve them for t and both fractions; return none where there is no single solution.
        // 3. Return none outside of the triangle or of the interval.
        // 4. Find the normal, of length 1, by the order of the corners.
        missing!("the hit within the interval", None, {
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
        })
    }
}

testing::examples! {
    let [a, b, c] = [(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)].map(|(x, y)| Point3::new(x, y, -2.0));
    let triangle = Triangle::new(a, b, c).unwrap();
    let hit = |x, y, z, dz| {
        hit_from([x, y, z], [0.0, 0.0, dz], &triangle).map(|hit| (hit.t, hit.normal.z()))
    };
    assert_close!(hit(1.0, 1.0, 0.0, -1.0), Some((2.0, 1.0)), "from the front");
    assert_close!(hit(1.0, 1.0, -4.0, 2.0), Some((1.0, 1.0)), "from the back, in longer steps");
    assert_close!(hit(1.0, 0.0, 0.0, -1.0), Some((2.0, 1.0)), "on an edge");
    assert!(hit(3.0, 3.0, 0.0, -1.0).is_none(), "no hit beyond an edge");
}
