//! Wrong solutions: another condition.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval, Plane};
use testing::exercise::{Check, Wrong};

use crate::disc;

/// A disc whose points follow from the step from the centre and the radius.
#[derive(Debug)]
struct Disc(Plane, Point3, f64, fn(Vector3, f64) -> bool);

impl Geometry for Disc {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let hit = self.0.hit(ray, within)?;
        (self.3)(ray.at(hit.t) - self.1, self.2).then_some(hit)
    }
}

fn check(check: &mut Check, is_on: fn(Vector3, f64) -> bool) {
    disc::check(check, |c, n, r| Ok(Disc(Plane::new(c, n)?, c, r, is_on)));
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "the whole plane",
        says: "t, just outside the rim",
        check: |c| check(c, |_, _| true),
    },
    Wrong {
        mistake: "the rim does not belong to the disc",
        says: "t, exactly the rim",
        check: |c| check(c, |p, r| p.magnitude() < r),
    },
    Wrong {
        mistake: "the square of the distance compared with the radius",
        says: "rim",
        check: |c| check(c, |p, r| p.magnitude() * p.magnitude() <= r),
    },
    Wrong {
        mistake: "a square instead of a circle",
        says: "rim",
        check: |c| {
            check(c, |p, r| {
                p.x().abs() <= r && p.y().abs() <= r && p.z().abs() <= r
            });
        },
    },
];
