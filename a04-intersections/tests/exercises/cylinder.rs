//! Tubes of many sizes, compared with the solution.

use crate::prelude::*;
use crate::solutions::cylinder::Cylinder;

pub fn check<G: Geometry>(check: &mut Check, new: impl Fn(f64, f64) -> Result<G, ArgumentError>) {
    compare(
        check,
        "tube of radius {} and height {}",
        (1.0, 2.0),
        |r| (r.between(0.1, 5.0), r.between(0.1, 9.0)),
        |(r, height)| Cylinder::new(r, height),
        |(r, height)| new(r, height),
    );
    show(check, new(1.0, 2.0), [1.5, 4.5, 4.5], [0.0, 0.9, 0.0]);
}

/// The first crossing that `counts`, by its number and its height as a fraction of the tube.
fn variant(c: &mut Check, counts: fn(usize, f64) -> bool) {
    check(c, move |r, height| {
        own(move |ray: &Ray, within| {
            let [o, d] = [ray.origin() - Point3::ORIGIN, ray.direction()];
            let flat = |v: Vector3| Vector3::new(v.x(), 0.0, v.z());
            let (a, b) = (flat(d).dot(d), flat(o).dot(d));
            let root = (b * b - a * (flat(o).dot(o) - r * r)).sqrt();
            let ts = [(-b - root) / a, (-b + root) / a].into_iter().enumerate();
            let mut ts = ts.filter(|(_, t)| within.contains(*t));
            let (_, t) = ts.find(|(number, t)| counts(*number, ray.at(*t).y() / height))?;
            Some(Hit::new(t, flat((o + d * t) * (1.0 / r)).as_normal()))
        })
    });
}

pub const VARIANTS: &[Variant] = &[
    wrong("over the rim, a ray meets the far wall", |c| {
        variant(c, |number, y| number == 0 && (0.0..=1.0).contains(&y));
    }),
    wrong("rim and bottom belong to the tube", |c| {
        variant(c, |_, y| 0.0 < y && y < 1.0)
    }),
    wrong("the tube has two ends", |c| variant(c, |_, y| y <= 1.0)),
];
