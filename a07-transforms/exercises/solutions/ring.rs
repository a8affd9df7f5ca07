//! `Ring`: a flat disc with a round hole.

use crate::prelude::*;

/// All points of a plane whose distance from a point is from `hole` to `r`.
#[derive(Clone, Copy, Debug)]
pub struct Ring {
    plane: Plane,
    c: Point3,
    hole: f64,
    r: f64,
}

impl Ring {
    /// The ring around `c`, perpendicular to the normal `n`, with the radius `r`
    /// and a hole of a smaller radius.
    pub fn new(c: Point3, n: Normal3, hole: f64, r: f64) -> Result<Self, ArgumentError> {
        let r = argument::length("radius r", r)?;
        let hole = argument::length("hole", hole)?;
        argument::check("hole", hole, hole < r, "less than the radius")?;
        let plane = Plane::new(c.checked("centre c")?, n)?;
        Ok(Self { plane, c, hole, r })
    }
}

impl Geometry for Ring {
    /// The hit of the plane, if it lies on the ring. `ray.at(t)` is a point of the ray, and `v.dot(v)` the square
    /// of a length.
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let hit = self.plane.hit(ray, within)?;
        missing!("where the ray meets the ring", Some(hit), {
            let from_centre = ray.at(hit.t) - self.c;
            let squared = from_centre.dot(from_centre);
            let is_beyond_hole = squared >= self.hole * self.hole;
            let is_within_rim = squared <= self.r * self.r;
            (is_beyond_hole && is_within_rim).then_some(hit)
        })
    }
}

testing::examples! {
    let ring = Ring::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0), 1.0, 2.0).unwrap();
    let hit = |x| hit_from([x, 3.0, 0.0], [0.0, -1.0, 0.0], &ring).map(|hit| hit.t);
    assert_close!(hit(1.0), Some(3.0), "the inner border belongs to it");
    assert_close!(hit(2.0), Some(3.0), "the outer border belongs to it");
    assert!([0.5, 2.5].map(hit) == [None; 2], "no hit in the hole and beside the ring");
}
