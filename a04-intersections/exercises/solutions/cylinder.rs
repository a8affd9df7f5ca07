//! `Cylinder`: a tube around the y axis.

use a02_math::Normal3;
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval};
use common::{ArgumentError, argument};

/// A tube around the y axis, from `y = 0` up to its height, open at both ends.
#[derive(Clone, Copy, Debug)]
pub struct Cylinder {
    r: f64,
    height: f64,
}

impl Cylinder {
    /// The tube of a radius `r` and a height.
    pub fn new(r: f64, height: f64) -> Result<Self, ArgumentError> {
        Ok(Self {
            r: argument::length("radius r", r)?,
            height: argument::length("height", height)?,
        })
    }
}

impl Geometry for Cylinder {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let (o, d) = (ray.origin(), ray.direction());
        // Seen from above the wall is a circle, and y does not matter.
        let a = d.x() * d.x() + d.z() * d.z();
        let b = o.x() * d.x() + o.z() * d.z();
        let c = o.x() * o.x() + o.z() * o.z() - self.r * self.r;
        let discriminant = b * b - a * c;
        if discriminant < 0.0 {
            return None;
        }
        let root = discriminant.sqrt();
        let crossings = [(-b - root) / a, (-b + root) / a];

        // Over the rim of the near wall, a ray may meet the far one.
        let is_on_wall = |t: f64| (0.0..=self.height).contains(&ray.at(t).y());
        let counts = |t: &f64| within.contains(*t) && is_on_wall(*t);
        let t = crossings.into_iter().find(counts)?;
        let p = ray.at(t);
        let normal = Normal3::new(p.x() / self.r, 0.0, p.z() / self.r);
        Some(Hit::new(t, normal))
    }
}
