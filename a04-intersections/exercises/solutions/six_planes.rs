//! `SixPlanes`: a box put together of planes, as the protocol does it.

use a02_math::{Normal3, Point3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval, Plane};
use common::ArgumentError;

/// A box of six planes: two across each axis, one through either corner.
#[derive(Debug)]
pub struct SixPlanes {
    lbf: [f64; 3],
    run: [f64; 3],
    /// Each with the number of its axis.
    planes: Vec<(usize, Plane)>,
}

impl SixPlanes {
    /// The box from its left, bottom, far corner to its right, upper, near one.
    pub fn new(lbf: Point3, run: Point3) -> Result<Self, ArgumentError> {
        let mut planes = Vec::new();
        let axes = [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)];
        for (axis, (x, y, z)) in axes.into_iter().enumerate() {
            let normal = Normal3::new(x, y, z);
            planes.push((axis, Plane::new(lbf, -normal)?));
            planes.push((axis, Plane::new(run, normal)?));
        }
        let [lbf, run] = [lbf, run].map(|corner| corner.to_glam().to_array());
        Ok(Self { lbf, run, planes })
    }
}

impl Geometry for SixPlanes {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let mut found: Option<Hit> = None;
        let hits = |(axis, plane): &(usize, Plane)| Some((*axis, plane.hit(ray, within)?));
        for (axis, hit) in self.planes.iter().filter_map(hits) {
            let point = ray.at(hit.t).to_glam();
            // Along its own axis the point is where the plane is, up to rounding.
            let mut others = (0..3).filter(|other| *other != axis);
            let is_on_face = others.all(|i| self.lbf[i] <= point[i] && point[i] <= self.run[i]);
            if is_on_face && found.is_none_or(|nearest| hit.t < nearest.t) {
                found = Some(hit);
            }
        }
        found
    }
}
