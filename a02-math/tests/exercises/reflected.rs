//! Vectors on both sides of surfaces, compared with the lesson's `Vector3::reflected_on`.

use crate::prelude::*;

pub fn reflected(v: Vector3, n: Normal3) -> Vector3 {
    v.reflected_on(n)
}

pub fn check(check: &mut Check, yours: fn(Vector3, Normal3) -> Vector3) {
    let numbers = |v: Vector3| v.to_glam().to_array();
    // To the side, along the normal, along the surface, and from behind.
    let ends = [(-2.0, 1.0), (0.0, 1.0), (3.0, 0.0), (1.0, -2.0)];
    check.compare(
        "v = {}, n = {}",
        ends.map(|(x, y)| ([x, y, 0.0], [0.0, 1.0, 0.0])),
        random(|r| {
            let n = vector(r.triple(5.0)).normalized();
            (r.triple(5.0), numbers(n.unwrap_or_default()))
        }),
        [reflected, yours],
        |reflected, (v, n)| numbers(reflected(vector(v), vector(n).as_normal())),
    );
    scene(check, |f| f.reflected = yours);
}

variants! { check:
    yours => reflected;
    right "the part along the normal less the rest" => |v, n| {
        let along = Vector3::from(n) * n.dot(v);
        along - (v - along)
    };
    wrong "v points away" => |v, n| -v.reflected_on(n);
    wrong "the part along the normal counts twice" => |v, n| Vector3::from(n) * n.dot(v) - v;
    wrong "a vector behind the surface stays behind" => |v, n| {
        Vector3::from(n) * (2.0 * n.dot(v).abs()) - v
    };
}
