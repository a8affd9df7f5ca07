//! Boxes anywhere, compared with the lesson's.

use crate::prelude::*;

/// On a face, from inside, away, past an edge, just touching an edge, and beside it.
const SIMPLE: [[[f64; 3]; 2]; 6] = [
    [[0.0, 1.0, 5.0], [0.0, 0.0, -1.0]],
    [[0.5, 1.0, 0.0], [1.0, 0.0, 0.0]],
    [[0.0, 1.0, 5.0], [0.0, 0.0, 1.0]],
    [[0.0, 4.0, 3.0], [0.0, -1.0, -1.0]],
    [[2.0, 1.0, 0.0], [-1.0, 0.0, 1.0]],
    [[3.0, 1.0, 0.0], [-1.0, 0.0, 1.0]],
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
        |(lbf, run)| AxisAlignedBox::new(point(lbf), point(run)),
        |(lbf, run)| new(point(lbf), point(run)),
    );
    let [lbf, run] = [point([-0.5, 0.0, -0.5]), point([0.5, 1.0, 0.5])];
    scene(
        check,
        "scene-3",
        a04_intersections::scenes::scene_3,
        new(lbf, run),
    );
}

/// The last entry into a slab and the first exit, each a `t` and its axis. Slabs along which
/// the direction is at most `parallel` are entered nowhere, but the ray may be outside.
fn span([lbf, run]: [Point3; 2], ray: &Ray, parallel: f64) -> Option<[(f64, usize); 2]> {
    let [o, d] = [ray.origin().to_glam(), ray.direction().to_glam()];
    let (lbf, run) = (lbf.to_glam(), run.to_glam());
    let (mut near, mut far) = ((f64::NEG_INFINITY, 0), (f64::INFINITY, 0));
    for axis in 0..3 {
        if d[axis].abs() <= parallel {
            ((lbf[axis]..=run[axis]).contains(&o[axis])).then_some(())?;
            continue;
        }
        let [a, b] = [lbf, run].map(|corner| (corner[axis] - o[axis]) / d[axis]);
        near = if a.min(b) > near.0 {
            (a.min(b), axis)
        } else {
            near
        };
        far = if a.max(b) < far.0 {
            (a.max(b), axis)
        } else {
            far
        };
    }
    Some([near, far])
}

fn variant(
    c: &mut Check,
    parallel: f64,
    choose: fn([f64; 2], Interval) -> Option<usize>,
    side: f64,
) {
    check(c, move |lbf, run| {
        own(move |ray: &Ray, within| {
            let ends = span([lbf, run], ray, parallel)?;
            let which = choose(ends.map(|(t, _)| t), within)?;
            let ((t, axis), mut normal) = (ends[which], [0.0; 3]);
            let outwards = ray.direction().to_glam()[axis].signum() * [-1.0, side][which];
            normal[axis] = outwards;
            Some(Hit::new(t, Normal3::from_glam(normal.into())))
        })
    });
}

fn first(ends: [f64; 2], within: Interval) -> Option<usize> {
    (0..2).find(|end| ends[0] <= ends[1] && within.contains(ends[*end]))
}

pub const VARIANTS: &[Variant] = &[
    right("parallel slabs apart", |c| variant(c, 0.0, first, 1.0)),
    wrong("from inside, the exit is the hit", |c| {
        variant(
            c,
            0.0,
            |ends, i| first(ends, i).filter(|end| *end == 0),
            1.0,
        );
    }),
    wrong(
        "edges belong to the box: entry and exit may be equal",
        |c| {
            variant(
                c,
                0.0,
                |ends, i| first(ends, i).filter(|_| ends[0] < ends[1]),
                1.0,
            );
        },
    ),
    wrong("a small coordinate of the direction is not parallel", |c| {
        variant(c, 1e-5, first, 1.0)
    }),
    wrong("from inside, the normal points out of the box, too", |c| {
        variant(c, 0.0, first, -1.0)
    }),
];
