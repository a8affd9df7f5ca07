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
        for axis in 0..3 {
            for (corner, outwards) in [(lbf, -1.0), (run, 1.0)] {
                let mut normal = [0.0; 3];
                normal[axis] = outwards;
                let normal = Normal3::from_glam(normal.into());
                planes.push((axis, Plane::new(corner, normal)?));
            }
        }
        Ok(Self {
            lbf: lbf.to_glam().to_array(),
            run: run.to_glam().to_array(),
            planes,
        })
    }
}

impl Geometry for SixPlanes {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        // Two mistakes are in here: find them by their traces in the picture.
        testing::missing("a box whose faces have no holes", ());
        testing::missing("a box whose front hides its back", ());

        let mut found: Option<Hit> = None;
        for (axis, plane) in &self.planes {
            let Some(hit) = plane.hit(ray, within) else {
                continue;
            };
            let point = ray.at(hit.t).to_glam();
            let is_on_face = (0..3).all(|i| self.lbf[i] <= point[i] && point[i] <= self.run[i]);
            if is_on_face {
                found = Some(hit);
            }
        }
        found
    }
}
