//! Wrong solutions.

use a02_math::{Direction, Normal3, Point3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval};
use testing::exercise::{Check, Wrong};

use crate::plane;

type Formula = fn(Point3, Normal3, &Ray, Interval) -> Option<Hit>;

/// A plane with a normal of length 1.
#[derive(Debug)]
struct Plane(Point3, Normal3, Formula);

impl Geometry for Plane {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        (self.2)(self.0, self.1, ray, within)
    }
}

fn check(check: &mut Check, formula: Formula) {
    plane::check(check, |a, n| Ok(Plane(a, n.unit("n")?, formula)));
}

fn t(a: Point3, n: Normal3, ray: &Ray) -> f64 {
    (a - ray.origin()).dot(n) / ray.direction().dot(n)
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "the interval is left out",
        says: "the plane lies behind",
        check: |c| {
            check(c, |a, n, ray, _| {
                let t = t(a, n, ray);
                t.is_finite().then(|| Hit::new(t, n))
            });
        },
    },
    Wrong {
        mistake: "the sign of the distance is wrong",
        says: "straight down",
        check: |c| {
            check(c, |a, n, ray, i| {
                let t = -t(a, n, ray);
                i.contains(t).then(|| Hit::new(t, n))
            });
        },
    },
    Wrong {
        mistake: "only from the side of the normal",
        says: "from the far side",
        check: |c| {
            check(c, |a, n, ray, i| {
                let t = t(a, n, ray);
                (ray.direction().dot(n) < 0.0 && i.contains(t)).then(|| Hit::new(t, n))
            });
        },
    },
    Wrong {
        mistake: "the distance from the plane in the place of t",
        says: "straight down",
        check: |c| {
            check(c, |a, n, ray, i| {
                let t = (a - ray.origin()).dot(n) / ray.direction().dot(n)
                    * ray.direction().magnitude();
                i.contains(t).then(|| Hit::new(t, n))
            });
        },
    },
    Wrong {
        mistake: "the normal is turned to the ray",
        says: "the normal, from the far side",
        check: |c| {
            check(c, |a, n, ray, i| {
                let t = t(a, n, ray);
                let n = if ray.direction().dot(n) > 0.0 { -n } else { n };
                i.contains(t).then(|| Hit::new(t, n))
            });
        },
    },
];
