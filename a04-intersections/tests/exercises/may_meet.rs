//! Rays just inside and just outside of spheres, compared with the solution.

use crate::prelude::*;

yours! { may_meet }

type Code = fn(Point3, f64, &Ray) -> bool;

pub fn exercise() -> Exercise<Code> {
    let ray = |o, d| Ray::derived(point(o), vector(d));
    // Ahead, behind, from inside, touching, and from the border away.
    let rays = [
        [0.0, -5.0],
        [0.0, 5.0],
        [0.0, 1.0],
        [2.0, -5.0],
        [-2.0, -5.0],
        [0.0, 2.0],
        [-3.0, -5.0],
    ];
    let mut simple = Vec::new();
    for [x, y] in rays {
        simple.push(([0.0; 3], 2.0, [x, y, 0.0], [0.0, 1.0, 0.0]));
    }
    for length in [1e-18, 1e18] {
        for [x, y] in [[1.0, -5.0], [1.0, 5.0], [3.0, -5.0]] {
            simple.push(([0.0; 3], 2.0, [x, y, 0.0], [0.0, length, 0.0]));
        }
    }
    let spheres = Questions {
        words: "sphere around {} of radius {}, ray from {} along {}",
        simple,
        others: random(|r| {
            let (c, o, length) = (r.triple(5.0), r.triple(5.0), r.scale());
            let d = r.triple(5.0).map(|x| x * length);
            let nearest = ray(o, d).at(ray(o, d).t_of(point(c)).max(0.0)) - point(c);
            let factor = [0.5, 1.0 - 1e-6, 1.0 + 1e-6, 2.0][r.below(4) as usize];
            (c, nearest.magnitude() * factor, o, d)
        }),
        answer: |may_meet: &Code, (c, r, o, d)| {
            may_meet(point(c), r, &Ray::derived(point(o), vector(d)))
        },
    };
    Exercise {
        questions: spheres.into(),
        ..Exercise::default()
    }
}
