//! Rotations about axes of all lengths, compared with the solution.

use crate::prelude::*;
use crate::solutions::rotated::rotated as right;

yours! { rotated }

type Code = fn(Vector3, Vector3, f64) -> Vector3;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    let v = [1.0, 2.0, 3.0];
    let rotations = Questions {
        words: "v = {}, around {} by the angle {}",
        simple: vec![
            (v, [0.0, 0.0, 1.0], 1.0),
            (v, [0.0, 0.0, 2.0], 1.0),
            (v, [0.0, 0.0, -1.0], 1.0),
            (v, [1.0, 0.0, 0.0], -1.0),
            (v, [0.0, 0.0, 0.0], 1.0),
            (v, [0.0, 0.0, 1.0], 0.0),
            (v, [0.0, 0.0, 1e-18], 1.0),
            (v, [0.0, 0.0, 1e18], 1.0),
        ],
        others: random(|r| {
            let length = r.scale();
            let axis = r.triple(9.0).map(|x| x * length);
            (r.triple(9.0), axis, r.between(-7.0, 7.0))
        }),
        answer: |rotated: &Code, (v, axis, angle)| array(rotated(vector(v), vector(axis), angle)),
    };
    Exercise {
        questions: rotations.into(),
        wrong: vec![
            Other::new(
                "k × v points to the left, v × k to the right",
                |v, axis, angle| right(v, axis, -angle),
            ),
            Other::new(
                "the angle is in radians, not in degrees",
                |v, axis, angle| right(v, axis, angle.to_radians()),
            ),
            Other::new("the part along the axis stays", |v, axis, angle| {
                let along = v.projected_on(axis).unwrap_or_default();
                right(v - along, axis, angle)
            }),
            Other::new("the axis may have any length", |v, k, angle| {
                let (sin, cos) = libm::sincos(angle);
                v * cos + k.cross(v) * sin + k * (k.dot(v) * (1.0 - cos))
            }),
        ],
        ..Exercise::default()
    }
}
