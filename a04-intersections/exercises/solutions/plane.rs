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
    /// A ray has `origin()` and `direction()`, `p.dot(q)` is the dot product of vectors and normals, `within.contains(t)` says
    /// whether the hit is valid, and `Hit::new(t, normal)` makes it.
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        // 1. Put the ray into the equation of the plane, and solve it for t.
        // 2. Reject a t outside of the interval; what is t of a parallel ray?
        // 3. Return the hit with the normal of the plane.
        missing!("the hit within the interval", None, {
            let to_a = self.a - ray.origin();
            let t = to_a.dot(self.n) / ray.direction().dot(self.n);
            if !within.contains(t) {
                return None;
            }
            Some(Hit::new(t, self.n))
        })
    }
}

testing::examples! {
    let floor = Plane::new(Point3::new(0.0, -1.0, 0.0), Normal3::new(0.0, 1.0, 0.0)).unwrap();
    let hit = |y, dy| {
        hit_from([0.0, y, 0.0], [1.0, dy, 0.0], &floor).map(|hit| (hit.t, hit.normal.y()))
    };
    assert_close!(hit(0.0, -1.0), Some((1.0, 1.0)), "from above");
    assert_close!(hit(-3.0, 1.0), Some((2.0, 1.0)), "from below");
    assert!(hit(0.0, 1.0).is_none(), "no hit on a plane behind");
    assert!(hit(0.0, 0.0).is_none(), "no hit along the plane");
}
