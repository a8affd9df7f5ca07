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

/// A box put together of planes, of whose hits `is_on_face` judges the distances to the
/// slabs along its own axis and along both others, and of which `replaces` keeps one.
fn variant(c: &mut Check, is_on_face: fn(f64, f64) -> bool, replaces: fn(&Hit, &Hit) -> bool) {
    check(c, move |lbf, run| {
        own(move |ray: &Ray, within| {
            let mut found: Option<Hit> = None;
            for (axis, corner, side) in
                (0..3).flat_map(|axis| [(axis, lbf, -1.0), (axis, run, 1.0)])
            {
                let mut normal = [0.0; 3];
                normal[axis] = side;
                let plane = Plane::new(corner, vector(normal).as_normal()).ok()?;
                let Some(hit) = plane.hit(ray, within) else {
                    continue;
                };
                let [p, lbf, run] = [ray.at(hit.t), lbf, run].map(Point3::to_glam);
                let beside = (lbf - p).max(p - run);
                let others = beside[(axis + 1) % 3].max(beside[(axis + 2) % 3]);
                if is_on_face(beside[axis], others) && found.is_none_or(|old| replaces(&hit, &old))
                {
                    found = Some(hit);
                }
            }
            found
        })
    });
}

pub const VARIANTS: &[Variant] = &[
    wrong(
        "rounding puts a hit beside its own plane: compare the other two axes",
        |c| {
            variant(
                c,
                |own, others| own <= 0.0 && others <= 0.0,
                |a, b| a.t < b.t,
            );
        },
    ),
    wrong(
        "the nearest plane hides the others, not the last one",
        |c| {
            variant(c, |_, others| others <= 0.0, |_, _| true);
        },
    ),
    wrong(
        "an epsilon closes the holes, and lets the faces stick out",
        |c| {
            variant(
                c,
                |own, others| own <= 1e-4 && others <= 1e-4,
                |a, b| a.t < b.t,
            );
        },
    ),
];
