//! Tubes of many sizes, compared with the solution.

use crate::prelude::*;
use crate::solutions::cylinder::Cylinder;

/// On the wall, on the rim, at the bottom, over it to the far wall, from inside, touching,
/// above it, and along the axis.
const SIMPLE: [[[f64; 3]; 2]; 8] = [
    [[0.0, 1.0, 5.0], [0.0, 0.0, -1.0]],
    [[0.0, 2.0, 5.0], [0.0, 0.0, -1.0]],
    [[0.0, 0.0, 5.0], [0.0, 0.0, -2.0]],
    [[0.0, 4.0, 3.0], [0.0, -0.75, -1.0]],
    [[0.0, 1.0, 0.0], [0.0, 0.0, -1.0]],
    [[1.0, 1.0, 5.0], [0.0, 0.0, -1.0]],
    [[0.0, 2.5, 5.0], [0.0, 0.0, -1.0]],
    [[0.5, -5.0, 0.0], [0.0, 1.0, 0.0]],
];

pub fn check<G: Geometry>(check: &mut Check, new: impl Fn(f64, f64) -> Result<G, ArgumentError>) {
    compare(
        check,
        "tube of radius {} and height {}",
        ((1.0, 2.0), &SIMPLE),
        |r| (r.between(0.1, 5.0), r.between(0.1, 9.0)),
        |(r, height)| Cylinder::new(r, height),
        |(r, height)| new(r, height),
    );
    show(
        check,
        new(1.0, 2.0),
        Point3::new(1.5, 4.5, 4.5),
        Point3::new(0.0, 0.9, 0.0),
    );
}

/// The crossing that `counts`, by its number and its height as a fraction of the tube, and
/// the normal there.
fn variant(c: &mut Check, counts: fn(usize, f64) -> bool, normal: fn(Point3, f64) -> Vector3) {
    check(c, move |r, height| {
        own(move |ray: &Ray, within| {
            let (o, d) = (ray.origin(), ray.direction());
            let (a, b) = (d.x() * d.x() + d.z() * d.z(), o.x() * d.x() + o.z() * d.z());
            let root = (b * b - a * (o.x() * o.x() + o.z() * o.z() - r * r)).sqrt();
            let mut crossings = [(-b - root) / a, (-b + root) / a].into_iter().enumerate();
            let (_, t) = crossings.find(|(number, t)| {
                within.contains(*t) && counts(*number, ray.at(*t).y() / height)
            })?;
            Some(Hit::new(t, normal(ray.at(t), r).as_normal()))
        })
    });
}

fn outwards(p: Point3, r: f64) -> Vector3 {
    Vector3::new(p.x() / r, 0.0, p.z() / r)
}

pub const VARIANTS: &[Variant] = &[
    wrong("the far wall counts where the near one is not met", |c| {
        variant(
            c,
            |number, y| number == 0 && (0.0..=1.0).contains(&y),
            outwards,
        );
    }),
    wrong("rim and bottom belong to the tube", |c| {
        variant(c, |_, y| 0.0 < y && y < 1.0, outwards)
    }),
    wrong("the normal leads from the axis, not from the origin", |c| {
        let from_origin = |p: Point3, _| (p - Point3::ORIGIN).normalized().unwrap_or_default();
        variant(c, |_, y| (0.0..=1.0).contains(&y), from_origin);
    }),
];
