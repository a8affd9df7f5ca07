//! Normals and stretches of all kinds, compared with the solution.

use std::sync::Arc;

use crate::prelude::*;

yours! { stretched_normal => std::sync::Arc::new(stretched_normal) }

type Code = Arc<dyn Fn(Normal3, [f64; 3]) -> Option<Normal3> + Send + Sync>;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    let n = [1.0, 1.0, 0.0];
    let normals = Questions {
        words: "n = {}, factors {}".into(),
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
            Some(normal.to_glam().to_array())
        },
    };
    Exercise {
        questions: vec![normals.into()],
        wrong: vec![
            Other::from_right("a normal is divided where points are multiplied", |right| {
                Arc::new(move |n, factors| right(n, factors.map(|f| 1.0 / f)))
            }),
            Other::from_right("a mirror turns the normal, too", |right| {
                Arc::new(move |n, factors| right(n, factors.map(f64::abs)))
            }),
            Other::from_right("the normal is to have length 1 again", |right| {
                Arc::new(move |n, [x, y, z]| {
                    right(n, [x, y, z])?;
                    Some(Normal3::new(n.x() / x, n.y() / y, n.z() / z))
                })
            }),
        ],
        ..Exercise::default()
    }
}
