//! Wrong solutions: the roots with one part after the other left out.

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval};
use testing::exercise::{Check, Wrong};

use crate::sphere;

type Formula = fn(Point3, f64, &Ray, Interval) -> Option<Hit>;

#[derive(Debug)]
struct Sphere(Point3, f64, Formula);

impl Geometry for Sphere {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        (self.2)(self.0, self.1, ray, within)
    }
}

fn check(check: &mut Check, formula: Formula) {
    sphere::check(check, |c, r| Ok(Sphere(c, r, formula)));
}

/// Both roots of `a t² + 2 b t + c = 0`.
fn roots(a: f64, b: f64, c: f64) -> Option<[f64; 2]> {
    let discriminant = b * b - a * c;
    let root = (discriminant >= 0.0).then(|| discriminant.sqrt())?;
    Some([(-b - root) / a, (-b + root) / a])
}

fn both(c: Point3, r: f64, ray: &Ray) -> Option<[f64; 2]> {
    let (f, d) = (ray.origin() - c, ray.direction());
    roots(d.dot(d), f.dot(d), f.dot(f) - r * r)
}

fn hit(c: Point3, t: f64, ray: &Ray, scale: f64) -> Hit {
    let n: Vector3 = (ray.at(t) - c) * (1.0 / scale);
    Hit::new(t, n.as_normal())
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "only the near root",
        says: "from inside; sphere around",
        check: |c| {
            check(c, |c, r, ray, within| {
                let [t, _] = both(c, r, ray)?;
                within.contains(t).then(|| hit(c, t, ray, r))
            });
        },
    },
    Wrong {
        mistake: "the normal is not of length 1",
        says: "the normal, from outside",
        check: |c| {
            check(c, |c, r, ray, within| {
                let t = both(c, r, ray)?.into_iter().find(|t| within.contains(*t))?;
                Some(hit(c, t, ray, 1.0))
            });
        },
    },
    Wrong {
        mistake: "the direction is taken to have length 1",
        says: "t, from outside",
        check: |c| {
            check(c, |c, r, ray, within| {
                let (f, d) = (ray.origin() - c, ray.direction());
                let t = roots(1.0, f.dot(d), f.dot(f) - r * r)?;
                let t = t.into_iter().find(|t| within.contains(*t))?;
                Some(hit(c, t, ray, r))
            });
        },
    },
    Wrong {
        mistake: "the centre is left out",
        says: "from outside",
        check: |c| {
            check(c, |c, r, ray, within| {
                let t = both(Point3::ORIGIN, r, ray)?;
                let t = t.into_iter().find(|t| within.contains(*t))?;
                Some(hit(c, t, ray, r))
            });
        },
    },
    Wrong {
        mistake: "hits behind the origin count",
        says: "t, from inside; sphere around",
        check: |c| {
            check(c, |c, r, ray, within| {
                let ahead = |t: &f64| *t < within.max && (*t != 0.0);
                let t = both(c, r, ray)?.into_iter().find(ahead)?;
                Some(hit(c, t, ray, r))
            });
        },
    },
];
