//! Vectors of all lengths, compared with the solution.

use crate::prelude::*;

yours! { length }

type Code = fn(f64, f64, f64) -> f64;

pub fn exercise() -> Exercise<Code> {
    let vectors = Questions {
        words: "the vector ({}, {}, {})",
        simple: vec![
            (0.0, 3.0, 4.0),
            (0.0, 0.0, -2.0),
            (0.0, 0.0, 0.0),
            (-3.0, 0.0, -4.0),
            (0.0, 3e200, 4e200),
            (-3e200, -4e200, -1.0),
            (0.0, -3e-200, 4e-200),
            (0.0, 0.0, 1e-300),
            (0.0, 1e308, 0.0),
        ],
        others: random(|r| {
            let scale = [1e-299, 1e-160, 1.0, 1e160, 1e299][r.below(5) as usize];
            let [x, y, z] = r.triple(9.0).map(|x| x * scale);
            (x, y, z)
        }),
        answer: |length: &Code, (x, y, z)| length(x, y, z),
    };
    Exercise {
        questions: vectors.into(),
        ..Exercise::default()
    }
}
