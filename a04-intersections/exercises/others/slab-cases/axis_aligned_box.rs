//! `AxisAlignedBox` by slabs with cases: a ray parallel to a slab, or one against an axis.

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
        let mut entry = (f64::NEG_INFINITY, Normal3::default());
        let mut exit = (f64::INFINITY, Normal3::default());
        for axis in 0..3 {
            if d[axis] == 0.0 {
                if o[axis] < self.lbf[axis] || o[axis] > self.run[axis] {
                    return None;
                }
                continue;
            }
            let mut backwards = [0.0; 3];
            backwards[axis] = -d[axis].signum();
            let n = vector(backwards).as_normal();
            let to = |corner: &[f64; 3]| (corner[axis] - o[axis]) / d[axis];
            let (mut first, mut last) = (to(&self.lbf), to(&self.run));
            if first > last {
                (first, last) = (last, first);
            }
            if first > entry.0 {
                entry = (first, n);
            }
            if last < exit.0 {
                exit = (last, -n);
            }
        }
        if entry.0 > exit.0 {
            return None;
        }
        let mut hits = [entry, exit].into_iter();
        let (t, n) = hits.find(|(t, _)| within.contains(*t))?;
        Some(Hit::new(t, n))
    }
}
