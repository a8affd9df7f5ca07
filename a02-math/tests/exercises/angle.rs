//! Vectors of all lengths, compared with the lesson's `Vector3::angle`.

use crate::prelude::*;

pub fn angle(a: Vector3, b: Vector3) -> f64 {
    a.angle(b)
}

pub fn check(check: &mut Check, yours: fn(Vector3, Vector3) -> f64) {
    // A right angle, an obtuse one, a tiny one, and none.
    let ends = [(0.0, 2.0), (-2.0, 2.0), (1.0, 1e-9), (0.0, 0.0)];
    check.compare(
        "a = {}, b = {}",
        ends.map(|(x, y)| ([1.0, 0.0, 0.0], [x, y, 0.0])),
        random(|r| {
            let length = r.scale();
            (r.triple(5.0).map(|x| x * length), r.triple(5.0))
        }),
        [angle, yours],
        |angle, (a, b)| angle(vector(a), vector(b)),
    );
    scene(check, |f| f.angle = yours);
}

fn cosine(a: Vector3, b: Vector3) -> f64 {
    a.dot(b) / (a.magnitude() * b.magnitude())
}

variants! { check:
    yours => angle;
    right "half the angle, in a rhombus" => |a, b| {
        let (a, b) = (a * b.magnitude(), b * a.magnitude());
        2.0 * libm::atan2((a - b).magnitude(), (a + b).magnitude())
    };
    wrong "the cosine of a tiny angle rounds to 1" => |a, b| {
        libm::acos(cosine(a, b).clamp(-1.0, 1.0))
    };
    wrong "the dot product contains both lengths" => |a, b| libm::acos(a.dot(b).clamp(-1.0, 1.0));
    wrong "an obtuse angle has the sine of an acute one" => |a, b| {
        libm::asin((1.0 - cosine(a, b) * cosine(a, b)).sqrt())
    };
}
