//! `SixPlanes`: a box put together of planes, as the protocol does it.

use crate::prelude::*;

/// A box of six planes: two across each axis, one through either corner.
#[derive(Debug)]
pub struct SixPlanes {
    lbf: Point3,
    run: Point3,
}

impl SixPlanes {
    /// The box from its left, bottom, far corner to its right, upper, near one.
    pub fn new(lbf: Point3, run: Point3) -> Result<Self, ArgumentError> {
        let [lbf, run] = [lbf.checked("corner lbf")?, run.checked("corner run")?];
        Ok(Self { lbf, run })
    }
}

impl Geometry for SixPlanes {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let [lbf, run] = [self.lbf, self.run].map(Point3::to_glam);
        let mut found: Option<Hit> = None;
        for axis in 0..3 {
            for (corner, side) in [(self.lbf, -1.0), (self.run, 1.0)] {
                let mut normal = [0.0; 3];
                normal[axis] = side;
                let plane = Plane::new(corner, Normal3::from_glam(normal.into())).ok()?;
                let Some(hit) = plane.hit(ray, within) else {
                    continue;
                };
                let point = ray.at(hit.t).to_glam();
                // Along its own axis the point is where the plane is, up to rounding.
                let mut others = (0..3).filter(|other| *other != axis);
                let is_on_face = others.all(|i| lbf[i] <= point[i] && point[i] <= run[i]);
                if is_on_face && found.is_none_or(|nearest| hit.t < nearest.t) {
                    found = Some(hit);
                }
            }
        }
        found
    }
}
