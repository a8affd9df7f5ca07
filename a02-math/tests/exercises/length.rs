//! Vectors of all lengths, compared with the solution.

use crate::prelude::*;

yours! { length }

type Code = fn(f64, f64, f64) -> f64;
type Other = Variant<Code>;

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
        wrong: vec![
            Other::new("squares overflow", |x, y, z| divided([x, y, z], 1.0)),
            Other::new("the largest coordinate may be negative", |x, y, z| {
                divided([x, y, z], x.max(y).max(z))
            }),
            Other::new("0 / 0 is not a number", |x, y, z| {
                divided([x, y, z], x.abs().max(y.abs()).max(z.abs()))
            }),
        ],
        ..Exercise::default()
    }
}

/// The length of a vector that is divided by a number first, and multiplied by it afterwards.
fn divided(coordinates: [f64; 3], by: f64) -> f64 {
    let [x, y, z] = coordinates.map(|coordinate| coordinate / by);
    by * (x * x + y * y + z * z).sqrt()
}
