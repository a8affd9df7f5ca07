//! `Sphere`: all points at the same distance from a centre.
//!
//! Chapter: Intersections, section "Sphere". To compare afterwards:
//! `a04-intersections/src/sphere.rs`.

use a02_math::{Direction, Point3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval};
use common::ArgumentError;

/// The sphere around `c` with the radius `r`.
#[derive(Debug)]
pub struct Sphere {
    c: Point3,
    r: f64,
}

impl Sphere {
    pub fn new(c: Point3, r: f64) -> Result<Self, ArgumentError> {
        Ok(Self { c, r })
    }
}

impl Geometry for Sphere {
    /// The nearest hit whose `t` lies within the interval, with the unit normal that
    /// points out of the sphere. The direction of the ray may have any length.
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let from_center = ray.origin() - self.c;
        let a = ray.direction().dot(ray.direction());
        let b = ray.direction().dot(from_center);
        let root = (b * b - a * (from_center.dot(from_center) - self.r * self.r)).sqrt();
        for t in [(-b - root) / a, (-b + root) / a] {
            if within.contains(t) {
                let normal = (ray.at(t) - self.c).normalized()?;
                return Some(Hit::new(t, normal.as_normal()));
            }
        }
        None
    }
}
