//! `Plane`: flat and infinite.

use a02_math::{Direction, Normal3, Point3};
use a03_rays_cameras::Ray;
use common::ArgumentError;

use crate::{Geometry, Hit, Interval};

/// The plane through a point, perpendicular to a normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    pub(crate) a: Point3,
    pub(crate) n: Normal3,
}

impl Plane {
    /// The plane through `a` with a normal `n` of any length but 0.
    ///
    /// Best is a point `a` near the rest of the scene: the rounding error grows in
    /// proportion to the distance between `a` and the rays.
    pub fn new(a: Point3, n: Normal3) -> Result<Self, ArgumentError> {
        Ok(Self {
            a: a.checked("point a")?,
            n: n.unit("normal n")?,
        })
    }

    /// The normal of length 1.
    #[must_use]
    pub const fn normal(&self) -> Normal3 {
        self.n
    }
}

/// `t = ((a - o) · n) / (d · n)`: the distance of the origin from the plane,
/// divided by the approach to the plane in one step `d` along the ray.
impl Geometry for Plane {
    // ANCHOR: hit
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let to_a = self.a - ray.origin();
        let t = to_a.dot(self.n) / ray.direction().dot(self.n);
        // A parallel ray meets the plane nowhere or, within it, everywhere. Its t is
        // infinite or 0 / 0 = NaN, neither of which is in any interval: a miss.
        within.contains(t).then(|| {
            let scale = to_a.dot_of_magnitudes(self.n);
            Hit::new(t, self.n).with_scale(scale)
        })
    }
    // ANCHOR_END: hit
}
