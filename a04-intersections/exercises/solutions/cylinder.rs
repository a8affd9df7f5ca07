//! `Cylinder`: a tube around the y axis.

use crate::prelude::*;

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
    /// The nearest hit of the wall within the interval, with the unit normal that points away from the axis.
    ///
    /// `ray.at(t)` is a point of the ray, with `x()`, `y()` and `z()`. `within.contains(t)` says whether a hit is
    /// valid, and `Hit::new(t, Normal3::new(x, y, z))` makes it.
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let (o, d) = (ray.origin(), ray.direction());
        missing!("the first crossing that counts", None, {
            // Seen from above the wall is a circle, and y does not matter.
            let a = d.x() * d.x() + d.z() * d.z();
            let b = o.x() * d.x() + o.z() * d.z();
            let c = o.x() * o.x() + o.z() * o.z() - self.r * self.r;
            // NaN, which is in no interval, if the ray misses.
            let root = (b * b - a * c).sqrt();
            // Over the rim of the near wall, a ray may meet the far one.
            let is_on_wall = |t: f64| (0.0..=self.height).contains(&ray.at(t).y());
            let mut crossings = [(-b - root) / a, (-b + root) / a].into_iter();
            let t = crossings.find(|t| within.contains(*t) && is_on_wall(*t))?;
            let p = ray.at(t);
            Some(Hit::new(
                t,
                Normal3::new(p.x() / self.r, 0.0, p.z() / self.r),
            ))
        })
    }
}

testing::examples! {
    let tube = Cylinder::new(1.0, 2.0).unwrap();
    let hit = |y, z, dz| {
        hit_from([0.0, y, z], [0.0, -1.0, dz], &tube).map(|hit| (hit.t, hit.normal.z()))
    };
    assert_close!(hit(3.0, 3.0, -1.0), Some((2.0, 1.0)), "at the near wall");
    assert_close!(hit(5.0, 3.0, -1.0), Some((4.0, -1.0)), "over the rim, at the far wall");
    assert_close!(hit(1.0, 0.0, -1.0), Some((1.0, -1.0)), "from inside, at the bottom");
    assert!(hit(1.0, 0.0, 0.0).is_none(), "no hit down through the tube");
}
