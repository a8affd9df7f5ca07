//! Rotations about axes of all lengths, compared with the solution.

use std::sync::Arc;

use crate::prelude::*;

yours! { rotated => std::sync::Arc::new(rotated) }

type Code = Arc<dyn Fn(Vector3, Vector3, f64) -> Vector3 + Send + Sync>;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    let v = [1.0, 2.0, 3.0];
    let rotations = Questions {
        words: "v = {}, around {} by the angle {}".into(),
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
        answer: |rotated: &Code, (v, axis, angle)| {
            rotated(vector(v), vector(axis), angle).to_glam().to_array()
        },
    };
    Exercise {
        questions: vec![rotations.into()],
        wrong: vec![
            Other::from_right("k × v points to the left, v × k to the right", |right| {
                Arc::new(move |v, axis, angle| right(v, axis, -angle))
            }),
            Other::from_right("the angle is in radians, not in degrees", |right| {
                Arc::new(move |v, axis, angle| right(v, axis, angle.to_radians()))
            }),
            Other::from_right("the part along the axis stays", |right| {
                Arc::new(move |v, axis, angle| {
                    let along = v.projected_on(axis).unwrap_or_default();
                    right(v - along, axis, angle)
                })
            }),
            Other::new(
                "the axis may have any length",
                Arc::new(|v, k, angle| {
                    let (sin, cos) = libm::sincos(angle);
                    v * cos + k.cross(v) * sin + k * (k.dot(v) * (1.0 - cos))
                }),
            ),
        ],
        ..Exercise::default()
    }
}
