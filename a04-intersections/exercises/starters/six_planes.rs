//! `SixPlanes`: a box put together of planes, as the protocol does it.

use a02_math::{Normal3, Point3, Vector3};
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
        // Two mistakes are in here: find them by their traces in the picture.
        testing::missing("a box whose faces have no holes", ());
        testing::missing("a box whose front hides its back", ());

        let mut found: Option<Hit> = None;
        let hits = |(axis, plane): &(usize, Plane)| Some((*axis, plane.hit(ray, within)?));
        for (axis, hit) in self.planes.iter().filter_map(hits) {
            let point = ray.at(hit.t).to_glam();
            let is_on_face = (0..3).all(|i| self.lbf[i] <= point[i] && point[i] <= self.run[i]);
            if is_on_face {
                found = Some(hit);
            }
        }
        found
    }
}

testing::examples! {
    let [lbf, run] = [Point3::new(-1.0, -1.0, -1.0), Point3::new(1.0, 1.0, 1.0)];
    let cube = SixPlanes::new(lbf, run).unwrap();
    let hit = |z, dz| {
        let ray = Ray::derived(Point3::new(0.0, 0.0, z), Vector3::new(0.0, 0.0, dz));
        cube.hit(&ray, Interval::AHEAD).map(|hit| (hit.t, hit.normal.z()))
    };
    assert_eq!(hit(5.0, -1.0), Some((4.0, 1.0)), "from the front");
    assert_eq!(hit(-5.0, 1.0), Some((4.0, -1.0)), "from the back");
    assert_eq!(hit(0.0, -1.0), Some((1.0, -1.0)), "from inside");
}
