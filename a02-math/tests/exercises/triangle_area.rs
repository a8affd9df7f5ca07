//! Triangles, also flat and far away, compared with the solution.

use crate::prelude::*;

yours! { triangle_area }

type Code = fn(Point3, Point3, Point3) -> f64;

pub fn exercise() -> Exercise<Code> {
    let [o, x, y] = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 3.0, 0.0]];
    let triangles = Questions {
        words: "corners {}, {} and {}",
        simple: vec![
            (o, x, y),
            (y, x, o),
            (o, x, x),
            (o, x, [2.0, 1.0 / 256.0, 0.0]),
            // So flat that the sum of two sides rounds to the third one, and so far that products of
            // coordinates round.
            (o, x, [2.0, 1.0 / 1_073_741_824.0, 0.0]),
            (o, x, [1.0, 0.0, 1.0 / 1_073_741_824.0]),
            ([1e9; 3], [1e9 + 4.0, 1e9, 1e9], [1e9, 1e9 + 3.0, 1e9]),
            ([-1e9, 1e9, 0.0], [-1e9, 1e9, 8.0], [-1e9, 1e9 + 2.0, 1.0]),
        ],
        others: random(|r| (r.triple(9.0), r.triple(9.0), r.triple(9.0))),
        answer: |triangle_area: &Code, (a, b, c)| triangle_area(point(a), point(b), point(c)),
    };
    Exercise {
        questions: triangles.into(),
        ..Exercise::default()
    }
}
