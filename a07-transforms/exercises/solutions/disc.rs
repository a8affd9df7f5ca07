//! `Disc`: the part of a plane within a radius of a point.

use crate::prelude::*;

/// A round, flat disc. It has no thickness, and its rim belongs to it.
#[derive(Debug)]
pub struct Disc {
    plane: Plane,
    c: Point3,
    r: f64,
}

impl Disc {
    pub fn new(c: Point3, n: Normal3, r: f64) -> Result<Self, ArgumentError> {
        let plane = Plane::new(c, n)?;
        Ok(Self { plane, c, r })
    }
}

impl Geometry for Disc {
    /// The hit, if its `t` lies within the interval, with the normal of the plane.
    ///
    /// `self.plane.hit(ray, within)` is the hit of the plane, `ray.at(t)` a point of the ray, and `v.dot(v)` the
    /// square of a length.
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        // 1. Find the hit of the plane.
        // 2. Keep it if it is within the radius of the centre.
        missing!("the hit within the interval and the radius", None, {
            let hit = self.plane.hit(ray, within)?;
            let from_centre = ray.at(hit.t) - self.c;
            let is_within = from_centre.dot(from_centre) <= self.r * self.r;
            is_within.then_some(hit)
        })
    }
}

testing::examples! {
    let disc = Disc::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0), 2.0).unwrap();
    let hit = |x, z, dy| hit_from([x, 3.0, z], [0.0, dy, 0.0], &disc).map(|hit| hit.t);
    assert_close!(hit(0.0, 0.0, -1.0), Some(3.0), "in the middle");
    assert_close!(hit(2.0, 0.0, -1.0), Some(3.0), "on the rim");
    assert!(hit(2.0, 2.0, -1.0).is_none(), "no hit beside it");
    assert!(hit(0.0, 0.0, 1.0).is_none(), "no hit away from it");
}
