//! `AxisAlignedBox` by its six faces: the nearest of their hits. At an edge, the first face counts.

use crate::prelude::*;

#[derive(Debug)]
pub struct AxisAlignedBox {
    lbf: [f64; 3],
    run: [f64; 3],
}

impl AxisAlignedBox {
    pub fn new(lbf: Point3, run: Point3) -> Result<Self, ArgumentError> {
        Ok(Self {
            lbf: array(lbf),
            run: array(run),
        })
    }
}

impl Geometry for AxisAlignedBox {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let (o, d) = (array(ray.origin()), array(ray.direction()));
        let mut nearest: Option<Hit> = None;
        // From the last axis to the first, where the lesson goes from the first to the last.
        for axis in [2, 1, 0] {
            for (face, side) in [(self.run[axis], 1.0), (self.lbf[axis], -1.0)] {
                let t = (face - o[axis]) / d[axis];
                if !within.contains(t) || nearest.is_some_and(|hit| hit.t <= t) {
                    continue;
                }
                let is_on_face = (0..3).all(|other| {
                    let at = o[other] + t * d[other];
                    other == axis || (self.lbf[other]..=self.run[other]).contains(&at)
                });
                if is_on_face {
                    let mut normal = [0.0; 3];
                    normal[axis] = side;
                    nearest = Some(Hit::new(t, vector(normal).as_normal()));
                }
            }
        }
        nearest
    }
}
