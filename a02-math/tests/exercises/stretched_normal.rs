//! Normals and stretches of all kinds, compared with the solution.

use crate::prelude::*;
use crate::solutions::stretched_normal::stretched_normal as right;

yours! { stretched_normal }

type Code = fn(Normal3, [f64; 3]) -> Option<Normal3>;
type Other = Variant<Code>;

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
        wrong: vec![
            Other::new(
                "a normal is divided where points are multiplied",
                |n, factors| right(n, factors.map(|f| 1.0 / f)),
            ),
            Other::new("the normal is to have length 1 again", |n, [x, y, z]| {
                right(n, [x, y, z])?;
                Some(Normal3::new(n.x() / x, n.y() / y, n.z() / z))
            }),
        ],
        ..Exercise::default()
    }
}
