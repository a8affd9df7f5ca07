//! Points on both sides of planes, compared with the solution.

use crate::prelude::*;

yours! { signed_distance }

type Code = fn(Point3, Normal3, Point3) -> f64;

pub fn exercise() -> Exercise<Code> {
    let (a, up) = ([7.0, -1.0, 0.0], [0.0, 1.0, 0.0]);
    let points = Questions {
        words: "a, n and p {}",
        simple: vec![
            [a, up, [0.0, 0.0, 0.0]],
            [a, up, [0.0, -3.0, 5.0]],
            [a, up, [-4.0, -1.0, 9.0]],
            [[0.0; 3], [0.0, 0.0, 2.0], [1.0, 1.0, 3.0]],
            [[0.0; 3], [0.0, 0.0, 1e-18], [1.0, 1.0, 3.0]],
            [[0.0; 3], [0.0, 0.0, 1e18], [1.0, 1.0, 3.0]],
        ],
        others: random(|r| [(); 3].map(|()| r.triple(9.0))),
        answer: |distance: &Code, [a, n, p]: [[f64; 3]; 3]| {
            distance(point(a), vector(n).as_normal(), point(p))
        },
    };
    Exercise {
        questions: points.into(),
        ..Exercise::default()
    }
}
