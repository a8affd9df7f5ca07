//! `SixPlanes`: a box put together of planes, as the protocol does it.

use crate::prelude::*;

/// A box of six planes: two across each axis, one through either corner.
#[derive(Debug)]
pub struct SixPlanes {
    lbf: Point3,
    run: Point3,
}

impl SixPlanes {
    /// The box from its left, bottom, far corner to its right, upper, near one.
    pub fn new(lbf: Point3, run: Point3) -> Result<Self, ArgumentError> {
        let [lbf, run] = [lbf.checked("corner lbf")?, run.checked("corner run")?];
        Ok(Self { lbf, run })
    }

    /// The hit of the planes. Two mistakes are in here: find them by their traces in the picture.
    fn hit_of_planes(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let [lbf, run] = [self.lbf, self.run].map(Point3::to_glam);
        let mut found: Option<Hit> = None;
        for axis in 0..3 {
            for (corner, side) in [(self.lbf, -1.0), (self.run, 1.0)] {
                let mut normal = [0.0; 3];
                normal[axis] = side;
                let plane = Plane::new(corner, Normal3::from_glam(normal.into())).ok()?;
                let Some(hit) = plane.hit(ray, within) else {
                    continue;
                };
                let point = ray.at(hit.t).to_glam();
                let is_on_face = (0..3).all(|i| lbf[i] <= point[i] && point[i] <= run[i]);
                if is_on_face {
                    found = Some(hit);
                }
            }
        }
        found
    }
}

impl Geometry for SixPlanes {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let found = self.hit_of_planes(ray, within);
        missing!("a box without holes, whose front hides its back", found, {
            let [lbf, run] = [self.lbf, self.run].map(Point3::to_glam);
            let mut found: Option<Hit> = None;
            for axis in 0..3 {
                for (corner, side) in [(self.lbf, -1.0), (self.run, 1.0)] {
                    let mut normal = [0.0; 3];
                    normal[axis] = side;
                    let plane = Plane::new(corner, Normal3::from_glam(normal.into())).ok()?;
                    let Some(hit) = plane.hit(ray, within) else {
                        continue;
                    };
                    let point = ray.at(hit.t).to_glam();
                    // Along its own axis the point is where the plane is, up to rounding.
                    let mut others = (0..3).filter(|other| *other != axis);
                    let is_on_face = others.all(|i| lbf[i] <= point[i] && point[i] <= run[i]);
                    if is_on_face && found.is_none_or(|nearest| hit.t < nearest.t) {
                        found = Some(hit);
                    }
                }
            }
            found
        })
    }
}

testing::examples! {
    let [lbf, run] = [Point3::new(-1.0, -1.0, -1.0), Point3::new(1.0, 1.0, 1.0)];
    let cube = SixPlanes::new(lbf, run).unwrap();
    let hit = |z, dz| {
        hit_from([0.0, 0.0, z], [0.0, 0.0, dz], &cube).map(|hit| (hit.t, hit.normal.z()))
    };
    assert_close!(hit(5.0, -1.0), Some((4.0, 1.0)), "from the front");
    assert_close!(hit(-5.0, 1.0), Some((4.0, -1.0)), "from the back");
    assert_close!(hit(0.0, -1.0), Some((1.0, -1.0)), "from inside");
}
