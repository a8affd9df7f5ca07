//! `AxisAlignedBox`: a box whose faces are perpendicular to the axes.

use crate::prelude::*;

/// A box between two opposite corners: every coordinate of `lbf`, the left, bottom, far
/// one, is at most the same coordinate of `run`, the right, upper, near one.
#[derive(Debug)]
pub struct AxisAlignedBox {
    lbf: [f64; 3],
    run: [f64; 3],
}

impl AxisAlignedBox {
    pub fn new(lbf: Point3, run: Point3) -> Result<Self, ArgumentError> {
        let [lbf, run] = [lbf, run].map(|corner| corner.to_glam().to_array());
        Ok(Self { lbf, run })
    }
}

impl Geometry for AxisAlignedBox {
    /// The nearest hit whose `t` lies within the interval, with the unit normal that points
    /// out of the box. The direction may have any length, and may be parallel to faces, which
    /// belong to the box: a ray within one hits it.
    ///
    /// `within.contains(t)` says whether a hit is valid, and `Hit::new(t, Normal3::new(x, y, z))` makes it.
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let (o, d) = (ray.origin().to_glam(), ray.direction().to_glam());
        // 1. For each axis, find where the ray enters and leaves the slab between the two faces.
        // 2. Find the last entry and the first exit, and remember their axes.
        // 3. Return none if the ray leaves a slab before it enters all.
        // 4. Choose the entry, or, from inside, the exit, whichever is within the interval.
        // 5. Find the outward normal of that face.
        missing!("the nearest hit within the interval", None, {
            let (mut near, mut near_axis) = (f64::NEG_INFINITY, 0);
            let (mut far, mut far_axis) = (f64::INFINITY, 0);
            for axis in 0..3 {
                let a = (self.lbf[axis] - o[axis]) / d[axis];
                let b = (self.run[axis] - o[axis]) / d[axis];
                let entered = a.max(near).min(b.max(near));
                let left = a.min(far).max(b.min(far));
                if entered > near {
                    (near, near_axis) = (entered, axis);
                }
                if left < far {
                    (far, far_axis) = (left, axis);
                }
            }
            if near > far {
                return None;
            }
            let is_entry = within.contains(near);
            let (t, axis, side) = if is_entry {
                (near, near_axis, -1.0)
            } else {
                (far, far_axis, 1.0)
            };
            if !within.contains(t) {
                return None;
            }
            let mut normal = [0.0; 3];
            normal[axis] = 1.0_f64.copysign(side * d[axis]);
            let [x, y, z] = normal;
            Some(Hit::new(t, Normal3::new(x, y, z)))
        })
    }
}

testing::examples! {
    let [lbf, run] = [-1.0, 1.0].map(|x| Point3::new(x, x, x));
    let cube = AxisAlignedBox::new(lbf, run).unwrap();
    let hit = |x, z, dz| {
        hit_from([x, 0.0, z], [0.0, 0.0, dz], &cube).map(|hit| (hit.t, hit.normal.z()))
    };
    assert_close!(hit(0.0, 5.0, -1.0), Some((4.0, 1.0)), "straight ahead");
    assert_close!(hit(0.0, 0.0, -1.0), Some((1.0, -1.0)), "from inside");
    assert!(hit(0.0, 5.0, 1.0).is_none(), "no hit on a box behind");
    assert!(hit(1.5, 5.0, -1.0).is_none(), "no hit beside it");
}
