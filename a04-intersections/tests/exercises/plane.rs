//! Planes anywhere, compared with the lesson's.

use crate::prelude::*;

/// Down to the floor, up from it, up to it, parallel to it, and in it.
const SIMPLE: [[[f64; 3]; 2]; 5] = [
    [[0.0, 0.0, 0.0], [0.0, -0.5, 0.0]],
    [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
    [[0.0, -3.0, 0.0], [0.0, 1.0, 1.0]],
    [[0.0, 0.0, 0.0], [3.0, 0.0, 1.0]],
    [[4.0, -1.0, 2.0], [3.0, 0.0, 1.0]],
];

pub fn check<G: Geometry>(
    check: &mut Check,
    new: impl Fn(Point3, Normal3) -> Result<G, ArgumentError>,
) {
    let floor = ([0.0, -1.0, 0.0], [0.0, 1.0, 0.0]);
    compare(
        check,
        "plane through {}, normal {}",
        (floor, &SIMPLE),
        |r| (r.triple(5.0), r.triple(5.0)),
        |(a, n)| Plane::new(point(a), vector(n).as_normal()),
        |(a, n)| new(point(a), vector(n).as_normal()),
    );
    scene(
        check,
        "scene-1",
        a04_intersections::scenes::scene_1,
        new(point(floor.0), vector(floor.1).as_normal()),
    );
}

/// A plane in the form n · p + k = 0, for which a direction is parallel up to an epsilon.
fn variant(c: &mut Check, parallel: f64) {
    check(c, move |a, n| {
        let n = n.unit("n")?;
        let k = -n.dot(a - Point3::ORIGIN);
        own(move |ray: &Ray, within| {
            let approach = n.dot(ray.direction());
            let t = -(n.dot(ray.origin() - Point3::ORIGIN) + k) / approach;
            (approach.abs() > parallel && within.contains(t)).then(|| Hit::new(t, n))
        })
    });
}

pub const VARIANTS: &[Variant] = &[
    right("the plane as n · p + k = 0", |c| variant(c, 0.0)),
    wrong(
        "a small d · n is not parallel: d may have any length",
        |c| variant(c, 1e-6),
    ),
];
