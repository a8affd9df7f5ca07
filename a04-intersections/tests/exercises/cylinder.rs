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

/// The crossing that `accepts` chooses by the height as a fraction of the tube, and the
/// normal there.
fn variant(
    c: &mut Check,
    crossings: fn([f64; 3]) -> [f64; 2],
    accepts: fn(f64) -> bool,
    normal: fn(Point3, f64) -> Normal3,
) {
    check(c, move |r, height| {
        own(move |ray: &Ray, within| {
            let (o, d) = (ray.origin(), ray.direction());
            let a = d.x() * d.x() + d.z() * d.z();
            let b = o.x() * d.x() + o.z() * d.z();
            let ts = crossings([a, b, o.x() * o.x() + o.z() * o.z() - r * r]);
            let t = ts
                .into_iter()
                .find(|t| within.contains(*t) && accepts(ray.at(*t).y() / height))?;
            Some(Hit::new(t, normal(ray.at(t), r)))
        })
    });
}

fn both([a, b, k]: [f64; 3]) -> [f64; 2] {
    let root = (b * b - a * k).sqrt();
    [(-b - root) / a, (-b + root) / a]
}

fn outwards(p: Point3, r: f64) -> Normal3 {
    Normal3::new(p.x() / r, 0.0, p.z() / r)
}

fn is_on_wall(height: f64) -> bool {
    (0.0..=1.0).contains(&height)
}

pub const VARIANTS: &[Variant] = &[
    right("the height as a fraction", |c| {
        variant(c, both, is_on_wall, outwards)
    }),
    wrong("the far wall counts where the near one is not met", |c| {
        variant(c, |abk| [both(abk)[0]; 2], is_on_wall, outwards);
    }),
    wrong("rim and bottom belong to the tube", |c| {
        variant(c, both, |y| 0.0 < y && y < 1.0, outwards)
    }),
    wrong("the direction may have any length, so a is not 1", |c| {
        variant(c, |[_, b, k]| both([1.0, b, k]), is_on_wall, outwards);
    }),
    wrong(
        "the normal has length 1 and leads from the axis, not from the origin",
        |c| {
            variant(c, both, is_on_wall, |p, _| {
                (p - Point3::ORIGIN)
                    .normalized()
                    .unwrap_or_default()
                    .as_normal()
            });
        },
    ),
];
