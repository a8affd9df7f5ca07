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
    ///
    /// A ray has `origin()` and `direction()`, and `a.dot(b)` is a dot product. `within.contains(t)` says
    /// whether a hit is valid, `Hit::new(t, normal)` makes it, and `vector.normalized()?.as_normal()` is a
    /// normal of length 1.
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        // 1. Put the ray into the equation of the sphere: a quadratic equation for t.
        // 2. Return none if it has no root.
        // 3. Choose the first root within the interval.
        // 4. Find the outward normal at that point, of length 1.
        missing!("the nearest hit within the interval", None, {
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
        })
    }
}

testing::examples! {
    let ball = Sphere::new(Point3::new(0.0, 0.0, -3.0), 0.5).unwrap();
    let hit = |x, z, dz| {
        hit_from([x, 0.0, z], [0.0, 0.0, dz], &ball).map(|hit| (hit.t, hit.normal.z()))
    };
    assert_close!(hit(0.0, 0.0, -2.0), Some((1.25, 1.0)), "in longer steps");
    assert_close!(hit(0.0, -3.0, -1.0), Some((0.5, -1.0)), "from inside");
    assert_close!(hit(0.5, 0.0, -1.0), Some((3.0, 0.0)), "touching");
    assert!(hit(1.0, 0.0, -1.0).is_none(), "no hit beside it");
}
