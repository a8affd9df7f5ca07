//! `AxisAlignedBox`: a box whose faces are perpendicular to the axes.
//!
//! Chapter: Intersections, section "Box". To compare afterwards:
//! `a04-intersections/src/axis_aligned_box.rs`.

use a02_math::{Normal3, Point3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval};
use common::ArgumentError;

/// A box between two opposite corners: every coordinate of `lbf`, the left, bottom, far
/// one, is at most the same coordinate of `run`, the right, upper, near one.
#[derive(Debug)]
pub struct AxisAlignedBox {
    lbf: [f64; 3],
    run: [f64; 3],
}

impl AxisAlignedBox {
    pub fn new(lbf: Point3, run: Point3) -> Result<Self, ArgumentError> {
        Ok(Self {
            lbf: lbf.to_glam().to_array(),
            run: run.to_glam().to_array(),
        })
    }
}

impl Geometry for AxisAlignedBox {
    /// The nearest hit whose `t` lies within the interval, with the unit normal that
    /// points out of the box. The direction of the ray may have any length, and may be
    /// parallel to faces.
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let o = ray.origin().to_glam().to_array();
        let d = ray.direction().to_glam().to_array();
        testing::missing("the nearest hit within the interval", None)
    }
}
