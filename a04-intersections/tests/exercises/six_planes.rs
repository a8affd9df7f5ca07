//! Boxes of six planes anywhere, compared with the solution.

use crate::prelude::*;
use crate::solutions::six_planes::SixPlanes;

/// On a face, from inside, away, on an edge, and beside it.
const SIMPLE: [[[f64; 3]; 2]; 5] = [
    [[0.0, 1.0, 5.0], [0.0, 0.0, -1.0]],
    [[0.5, 1.0, 0.0], [1.0, 0.0, 0.0]],
    [[0.0, 1.0, 5.0], [0.0, 0.0, 1.0]],
    [[1.0, 1.0, 5.0], [0.0, 0.0, -1.0]],
    [[1.5, 1.0, 5.0], [0.0, 0.0, -1.0]],
];

pub fn check<G: Geometry>(
    check: &mut Check,
    new: impl Fn(Point3, Point3) -> Result<G, ArgumentError>,
) {
    compare(
        check,
        "box from {} to {}",
        (([-1.0, 0.0, -1.0], [1.0, 2.0, 1.0]), &SIMPLE),
        |r| {
            let lbf = r.triple(5.0);
            (lbf, lbf.map(|low| low + r.between(0.1, 3.0)))
        },
        |(lbf, run)| SixPlanes::new(point(lbf), point(run)),
        |(lbf, run)| new(point(lbf), point(run)),
    );
    let shape = new(point([-0.3, 0.1, -0.7]), point([0.4, 1.2, 0.6]));
    show(
        check,
        shape,
        Point3::new(2.0, 2.2, 2.9),
        Point3::new(0.05, 0.6, 0.0),
    );
}

/// A box of which `is_on_face` judges three flags: whether the hit of a plane is between the
/// corners along its own axis, and along both others, up to an epsilon.
fn variant(
    c: &mut Check,
    beside: f64,
    is_on_face: fn(bool, [bool; 2]) -> bool,
    replaces: fn(&Hit, &Hit) -> bool,
) {
    check(c, move |lbf, run| {
        own(move |ray: &Ray, within| {
            let mut found: Option<Hit> = None;
            for (axis, corner, outwards) in
                (0..3).flat_map(|axis| [(axis, lbf, -1.0), (axis, run, 1.0)])
            {
                let mut normal = [0.0; 3];
                normal[axis] = outwards;
                let plane = Plane::new(corner, vector(normal).as_normal()).ok()?;
                let Some(hit) = plane.hit(ray, within) else {
                    continue;
                };
                let [p, lbf, run] = [ray.at(hit.t), lbf, run].map(Point3::to_glam);
                let is_between =
                    |axis| lbf[axis] - beside <= p[axis] && p[axis] <= run[axis] + beside;
                let others = [is_between((axis + 1) % 3), is_between((axis + 2) % 3)];
                if is_on_face(is_between(axis), others)
                    && found.is_none_or(|old| replaces(&hit, &old))
                {
                    found = Some(hit);
                }
            }
            found
        })
    });
}

pub const VARIANTS: &[Variant] = &[
    right("each plane anew", |c| {
        variant(c, 0.0, |_, others| others == [true; 2], |a, b| a.t < b.t)
    }),
    wrong(
        "rounding puts a hit beside its own plane: compare the other two axes",
        |c| {
            variant(
                c,
                0.0,
                |own, others| own && others == [true; 2],
                |a, b| a.t < b.t,
            );
        },
    ),
    wrong(
        "the nearest plane hides the others, not the last one",
        |c| {
            variant(c, 0.0, |_, others| others == [true; 2], |_, _| true);
        },
    ),
    wrong(
        "an epsilon closes the holes, and lets the faces stick out",
        |c| {
            variant(
                c,
                1e-4,
                |own, others| own && others == [true; 2],
                |a, b| a.t < b.t,
            );
        },
    ),
    wrong(
        "each plane has its own hit in the interval, which has to choose first",
        |c| {
            check(c, |lbf, run| {
                let shape = SixPlanes::new(lbf, run)?;
                own(move |ray: &Ray, i: Interval| {
                    shape
                        .hit(ray, Interval::AHEAD)
                        .filter(|hit| i.contains(hit.t))
                })
            });
        },
    ),
];
