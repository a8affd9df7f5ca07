//! Rotations about axes of all lengths, compared with the solution.

use crate::prelude::*;

yours! { rotated }

type Code = fn(Vector3, Vector3, f64) -> Vector3;

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
        ..Exercise::default()
    }
}
