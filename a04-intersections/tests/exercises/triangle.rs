//! Triangles anywhere, compared with the lesson's.

use crate::prelude::*;

/// From the front, from the back, on two edges, on a corner, beyond the third edge, and in
/// the plane of the triangle.
const SIMPLE: [[[f64; 3]; 2]; 7] = [
    [[1.0, 1.0, 0.0], [0.0, 0.0, -1.0]],
    [[1.0, 1.0, -4.0], [0.0, 0.0, 1.0]],
    [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0]],
    [[2.0, 2.0, 0.0], [0.0, 0.0, -1.0]],
    [[0.0, 0.0, 0.0], [0.0, 0.0, -1.0]],
    [[3.0, 3.0, 0.0], [0.0, 0.0, -1.0]],
    [[1.0, 1.0, -2.0], [1.0, 0.5, 0.0]],
];

pub fn check<G: Geometry>(
    check: &mut Check,
    new: impl Fn(Point3, Point3, Point3) -> Result<G, ArgumentError>,
) {
    compare(
        check,
        "triangle {}",
        (
            [[0.0, 0.0, -2.0], [4.0, 0.0, -2.0], [0.0, 4.0, -2.0]],
            &SIMPLE,
        ),
        |r| [(); 3].map(|()| r.triple(5.0)),
        |[a, b, c]| Triangle::new(point(a), point(b), point(c)),
        |[a, b, c]| new(point(a), point(b), point(c)),
    );
    let [a, b, c] = [[-0.5, 0.5, -3.0], [0.5, 0.5, -3.0], [0.5, -0.5, -3.0]].map(point);
    scene(
        check,
        "scene-4",
        a04_intersections::scenes::scene_4,
        new(a, b, c),
    );
}

/// The test of Möller and Trumbore, which accepts a determinant and two coordinates.
fn moeller_trumbore(c: &mut Check, accepts: fn(f64, f64, f64) -> bool) {
    check(c, move |a, b, c| {
        let (ab, ac) = (b - a, c - a);
        own(move |ray: &Ray, within| {
            let (d, ao) = (ray.direction(), ray.origin() - a);
            let (p, q) = (d.cross(ac), ao.cross(ab));
            let determinant = ab.dot(p);
            let (beta, gamma) = (ao.dot(p) / determinant, d.dot(q) / determinant);
            let t = ac.dot(q) / determinant;
            let normal = ab.cross(ac).normalized()?.as_normal();
            let is_hit = accepts(determinant, beta, gamma) && within.contains(t);
            is_hit.then(|| Hit::new(t, normal))
        })
    });
}

fn is_inside(beta: f64, gamma: f64) -> bool {
    beta >= 0.0 && gamma >= 0.0 && beta + gamma <= 1.0
}

pub const VARIANTS: &[Variant] = &[
    right("Möller and Trumbore", |c| {
        moeller_trumbore(c, |_, b, g| is_inside(b, g))
    }),
    wrong(
        "a small determinant is not parallel: it depends on all lengths",
        |c| {
            moeller_trumbore(c, |det, b, g| det.abs() > 1e-6 && is_inside(b, g));
        },
    ),
    wrong("edges belong to the triangle", |c| {
        moeller_trumbore(c, |_, b, g| b > 0.0 && g > 0.0 && b + g < 1.0);
    }),
    wrong(
        "all three edges bound a triangle; two of them a wedge",
        |c| {
            moeller_trumbore(c, |_, b, g| b >= 0.0 && g >= 0.0);
        },
    ),
];
