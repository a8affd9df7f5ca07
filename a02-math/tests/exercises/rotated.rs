//! Turns around axes of all lengths, compared with the solution.

use crate::prelude::*;

pub fn check(check: &mut Check, yours: fn(Vector3, Vector3, f64) -> Vector3) {
    let numbers = |v: Vector3| v.to_glam().to_array();
    let z = |length| ([1.0, 2.0, 3.0], [0.0, 0.0, length], 90.0);
    check.compare(
        "v = {}, around {} by {} degrees",
        [z(1.0), z(2.0), z(-1.0), z(0.0)],
        random(|r| {
            let length = r.scale();
            let axis = r.triple(9.0).map(|x| x * length);
            (r.triple(9.0), axis, r.between(-360.0, 360.0))
        }),
        [rotated, yours],
        |rotated, (v, axis, angle)| numbers(rotated(vector(v), vector(axis), angle.to_radians())),
    );
}

variants! { check:
    yours => rotated;
    wrong "k × v points to the left, v × k to the right" => |v, axis, angle| {
        rotated(v, axis, -angle)
    };
    wrong "the part along the axis stays" => |v, axis, angle| {
        let along = v.projected_on(axis).unwrap_or_default();
        rotated(v - along, axis, angle)
    };
    wrong "the axis may have any length" => |v, k, angle| {
        let (sin, cos) = libm::sincos(angle);
        v * cos + k.cross(v) * sin + k * (k.dot(v) * (1.0 - cos))
    };
}
