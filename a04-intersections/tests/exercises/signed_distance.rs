//! Points on both sides of planes, compared with the solution.

use crate::prelude::*;
use crate::solutions::signed_distance::signed_distance as solution;

pub fn check(check: &mut Check, signed_distance: impl Fn(Point3, Normal3, Point3) -> f64) {
    let distance = |[a, n, p]: [[f64; 3]; 3], f: &dyn Fn(Point3, Normal3, Point3) -> f64| {
        f(point(a), vector(n).as_normal(), point(p))
    };
    let (a, up) = ([7.0, -1.0, 0.0], [0.0, 1.0, 0.0]);
    let above = [[0.0, 0.0, 0.0], [0.0, -3.0, 5.0], [-4.0, -1.0, 9.0]].map(|p| [a, up, p]);
    let long = [[0.0; 3], [0.0, 0.0, 2.0], [1.0, 1.0, 3.0]];
    check.compare(
        "a, n and p {}",
        above.into_iter().chain([long]),
        random(|r| [(); 3].map(|()| r.triple(9.0))),
        |input| distance(input, &solution),
        |input| distance(input, &signed_distance),
    );
}

pub const VARIANTS: &[Variant] = &[
    wrong("n may have any length: divide by it", |c| {
        check(c, |a, n, p| (p - a).dot(n))
    }),
    wrong("n · n is the length squared", |c| {
        check(c, |a, n, p| (p - a).dot(n) / n.dot(n))
    }),
    wrong("the distance from the plane is not that from a", |c| {
        check(c, |a, n, p| {
            Vector3::magnitude(p - a).copysign((p - a).dot(n))
        });
    }),
];
