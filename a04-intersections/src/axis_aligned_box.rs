//! `AxisAlignedBox`: a box whose faces are perpendicular to the axes.

use a02_math::{Normal3, Point3};
use a03_rays_cameras::Ray;
use common::ArgumentError;

use crate::{Geometry, Hit, Interval};

/// A box between two opposite corners.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisAlignedBox {
    pub(crate) lbf: [f64; 3],
    pub(crate) run: [f64; 3],
}

impl AxisAlignedBox {
    /// The box from its left, bottom, far corner `lbf` to its right, upper,
    /// near corner `run`. Any two opposite corners are valid; a box may be flat.
    pub fn new(lbf: Point3, run: Point3) -> Result<Self, ArgumentError> {
        let (lbf, run) = (lbf.checked("corner lbf")?, run.checked("corner run")?);
        Ok(Self {
            lbf: lbf.to_glam().min(run.to_glam()).to_array(),
            run: lbf.to_glam().max(run.to_glam()).to_array(),
        })
    }
}

/// Rounding moves each of the two distances that are compared by at most
/// `γ(3) = 3u / (1 - 3u)` of itself, with `u = 2^-53`. A slab that
/// is wider by this factor loses no ray along an edge or through a corner (Ize,
/// Robust BVH Ray Traversal, JCGT 2(2), 2013).
const WIDER: f64 = {
    let three_u = 1.5 * f64::EPSILON;
    1.0 + 2.0 * (three_u / (1.0 - three_u))
};

/// The box is the intersection of three slabs, one between each pair of faces. A
/// ray is inside from the last entry into a slab to the first exit.
impl Geometry for AxisAlignedBox {
    // ANCHOR: hit
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let o = ray.origin().to_glam().to_array();
        let d = ray.direction().to_glam().to_array();

        let (mut near, mut near_axis) = (f64::NEG_INFINITY, 0);
        let (mut far, mut far_axis) = (f64::INFINITY, 0);
        for axis in 0..3 {
            let inverse = 1.0 / d[axis];
            let a = (self.lbf[axis] - o[axis]) * inverse;
            let b = (self.run[axis] - o[axis]) * inverse;
            // A ray within a face is in this slab all the time, also if it starts
            // there. It has 0 · infinity = NaN for that face. `min` and `max` drop
            // a NaN, and in this order the slab leaves near and far as they are
            // (Barnes, "Fast, Branchless Ray/Bounding Box Intersections, Part
            // 2: NaNs", 2015).
            let entered = a.max(near).min(b.max(near));
            let left = a.min(far).max(b.min(far));
            if entered > near {
                (near, near_axis) = (entered, axis);
            }
            if left < far {
                (far, far_axis) = (left, axis);
            }
        }
        // Behind the origin, where t is negative, a quotient is the wider bound.
        let wider = if far < 0.0 { far / WIDER } else { far * WIDER };
        if near > wider {
            return None;
        }
        // By rounding, a ray through an edge may leave before it enters. With a
        // `t` below `near`, the same box twice in a list would hide itself.
        let far = far.max(near);

        if within.contains(near) {
            Some(Hit::new(near, axis_normal(near_axis, -d[near_axis])))
        } else if within.contains(far) {
            Some(Hit::new(far, axis_normal(far_axis, d[far_axis])))
        } else {
            None
        }
    }
    // ANCHOR_END: hit
}

/// The normal along an axis, on the side of `sign`.
fn axis_normal(axis: usize, sign: f64) -> Normal3 {
    let mut normal = [0.0; 3];
    normal[axis] = 1.0_f64.copysign(sign);
    Normal3::from_glam(normal.into())
}
