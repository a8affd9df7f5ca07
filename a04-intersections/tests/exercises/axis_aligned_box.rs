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
/// the direction is at most `parallel` are never entered, but the ray may be outside.
fn span([lbf, run]: [Point3; 2], ray: &Ray, parallel: f64) -> Option<[(f64, usize); 2]> {
    let [o, lbf, run] = [ray.origin(), lbf, run].map(Point3::to_glam);
    let d = ray.direction().to_glam();
    let (mut near, mut far) = ((f64::NEG_INFINITY, 0), (f64::INFINITY, 0));
    for axis in 0..3 {
        let [a, b] = [lbf, run].map(|corner| (corner[axis] - o[axis]) / d[axis]);
        if d[axis].abs() <= parallel {
            (lbf[axis] <= o[axis] && o[axis] <= run[axis]).then_some(())?;
        } else {
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
    }
    Some([near, far])
}

fn variant(c: &mut Check, parallel: f64, is_crossed: fn(f64, f64) -> bool) {
    check(c, move |lbf, run| {
        own(move |ray: &Ray, within| {
            let [near, far] = span([lbf, run], ray, parallel)?;
            let ends = [(near, -1.0), (far, 1.0)].into_iter();
            let mut hits =
                ends.filter(|((t, _), _)| is_crossed(near.0, far.0) && within.contains(*t));
            let ((t, axis), outwards) = hits.next()?;
            let mut normal = [0.0; 3];
            normal[axis] = outwards * ray.direction().to_glam()[axis].signum();
            Some(Hit::new(t, vector(normal).as_normal()))
        })
    });
}

pub const VARIANTS: &[Variant] = &[
    right("parallel slabs apart", |c| {
        variant(c, 0.0, |near, far| near <= far)
    }),
    wrong(
        "edges belong to the box: entry and exit may be equal",
        |c| {
            variant(c, 0.0, |near, far| near < far);
        },
    ),
    wrong("a small coordinate of the direction is not parallel", |c| {
        variant(c, 1e-5, |near, far| near <= far);
    }),
];
