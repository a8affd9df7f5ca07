//! Points on both sides of planes, compared with the solution.

use crate::prelude::*;

yours! { signed_distance }

type Code = fn(Point3, Normal3, Point3) -> f64;

pub fn exercise() -> Exercise<Code> {
    Exercise::asked(|distance: &Code, [a, n, p]: [[f64; 3]; 3]| {
        distance(point(a), vector(n).as_normal(), point(p))
    })
}
