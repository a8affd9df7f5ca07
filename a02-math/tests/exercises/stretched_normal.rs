//! Normals and stretches of all kinds, compared with the solution.

use crate::prelude::*;

yours! { stretched_normal }

type Code = fn(Normal3, [f64; 3]) -> Option<Normal3>;

pub fn exercise() -> Exercise<Code> {
    let n = [1.0, 1.0, 0.0];
    let normals = Questions {
        words: "n = {}, factors {}",
        simple: vec![
            (n, [2.0, 1.0, 1.0]),
            (n, [1.0, 0.0, 1.0]),
            ([0.0, 0.0, 1.0], [0.0, 1.0, 1.0]),
            (n, [-1.0, 1.0, 1.0]),
            (n, [0.0, 0.0, 0.0]),
            ([0.0, 0.0, 0.0], [2.0, 1.0, 1.0]),
        ],
        others: random(|r| {
            let scale = r.scale();
            let mut factor = || (r.between(0.1, 9.0) - 4.005) * scale;
            let factors = [factor(), factor(), factor()];
            (r.triple(1.0), factors)
        }),
        answer: |stretched_normal: &Code, (n, factors)| {
            let normal = stretched_normal(vector(n).as_normal(), factors)?;
            Some(array(normal))
        },
    };
    Exercise {
        questions: normals.into(),
        ..Exercise::default()
    }
}
