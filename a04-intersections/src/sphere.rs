//! `Sphere`: all points at the same distance from a centre.

use a02_math::{Direction, Point3};
use a03_rays_cameras::Ray;
use common::{ArgumentError, argument};

use crate::{Geometry, Hit, Interval, SQUARED_LENGTHS, hit_of_scaled_ray};

/// A sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    pub(crate) c: Point3,
    pub(crate) r: f64,
}

impl Sphere {
    /// The sphere around `c` with a radius `r` from 1e-100 to 1e100.
    pub fn new(c: Point3, r: f64) -> Result<Self, ArgumentError> {
        Ok(Self {
            c: c.checked("centre c")?,
            r: argument::length("radius r", r)?,
        })
    }
}

/// The roots of `a t² - 2 b t + (f · f - r²) = 0` with `f = o - c`, `a = d · d`
/// and `b = -f · d`, after Haines, Günther and Akenine-Möller, "Precision
/// Improvements for Ray/Sphere Intersection", Ray Tracing Gems (2019), chapter 7.
impl Geometry for Sphere {
    // ANCHOR: hit
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let (f, d) = (ray.origin() - self.c, ray.direction());
        let a = d.dot(d);
        if !SQUARED_LENGTHS.contains(&a) {
            return hit_of_scaled_ray(self, ray, within);
        }
        let middle = -f.dot(d) / a;

        // The discriminant b² - a (f · f - r²) subtracts two numbers as large
        // as the squared distance. Divided by a it is r² - l · l, where l is
        // the shortest vector from the centre to the ray.
        let l = f + d * middle;
        let discriminant = self.r * self.r - l.dot(l);
        if discriminant < 0.0 {
            return None;
        }

        // In b / a ± root, the sum of equal signs does not cancel; the other
        // root follows from their product (f · f - r²) / a.
        let root = (discriminant / a).sqrt();
        let t1 = if middle < 0.0 {
            middle - root
        } else {
            middle + root
        };
        let t0 = if t1 == 0.0 {
            // The ray touches the sphere at its own origin: both roots are 0.
            t1
        } else {
            (f.dot(f) - self.r * self.r) / (a * t1)
        };
        let (near, far) = if t0 < t1 { (t0, t1) } else { (t1, t0) };
        let t = [near, far].into_iter().find(|t| within.contains(*t))?;
        let normal = (f + d * t).normalized()?.as_normal();
        Some(Hit::new(t, normal).with_scale(self.r))
    }
    // ANCHOR_END: hit
}
