//! Vectors on both sides of surfaces, compared with the lesson's `Vector3::reflected_on`.

use crate::prelude::*;

yours! { reflected }

type Code = fn(Vector3, Normal3) -> Vector3;
type Other = Variant<Code>;

pub fn reflected(v: Vector3, n: Normal3) -> Vector3 {
    v.reflected_on(n)
}

pub fn exercise() -> Exercise<Code> {
    let up = [0.0, 1.0, 0.0];
    let vectors = Questions {
        words: "v = {}, n = {}".into(),
        // To the side, along the normal, along the surface, and from behind.
        simple: vec![
            ([-2.0, 1.0, 0.0], up),
            ([0.0, 1.0, 0.0], up),
            ([3.0, 0.0, 0.0], up),
            ([1.0, -2.0, 0.0], up),
        ],
        others: random(|r| {
            let n = vector(r.triple(5.0)).normalized().unwrap_or_default();
            (r.triple(5.0), n.to_glam().to_array())
        }),
        answer: |reflected: &Code, (v, n)| {
            reflected(vector(v), vector(n).as_normal())
                .to_glam()
                .to_array()
        },
    };
    Exercise {
        questions: vec![vectors.into()],
        picture: scene(|reflected: &Code| Functions {
            reflected: *reflected,
            ..LESSON
        }),
        right: vec![Other::new(
            "the part along the normal less the rest",
            |v, n| {
                let along = Vector3::from(n) * n.dot(v);
                along - (v - along)
            },
        )],
        wrong: vec![
            Other::new("v points away", |v, n| -v.reflected_on(n)),
            Other::new("the part along the normal counts twice", |v, n| {
                Vector3::from(n) * n.dot(v) - v
            }),
            Other::new("a vector behind the surface stays behind", |v, n| {
                Vector3::from(n) * (2.0 * n.dot(v).abs()) - v
            }),
        ],
        ..Exercise::default()
    }
}
