//! Vectors of all lengths, compared with the lesson's `Vector3::angle`.

use crate::prelude::*;

yours! { angle }

type Code = fn(Vector3, Vector3) -> f64;
type Other = Variant<Code>;

pub fn angle(a: Vector3, b: Vector3) -> f64 {
    a.angle(b)
}

pub fn exercise() -> Exercise<Code> {
    let x = [1.0, 0.0, 0.0];
    let vectors = Questions {
        words: "a = {}, b = {}".into(),
        // A right angle, an obtuse one, a tiny one, none, and vectors that differ much in length.
        simple: vec![
            (x, [0.0, 2.0, 0.0]),
            (x, [-2.0, 2.0, 0.0]),
            (x, [1.0, 1e-9, 0.0]),
            (x, [0.0, 0.0, 0.0]),
            ([1e-18, 0.0, 0.0], [-2.0, 2.0, 0.0]),
            ([1e18, 0.0, 0.0], [-2.0, 2.0, 0.0]),
        ],
        others: random(|r| {
            let length = r.scale();
            (r.triple(5.0).map(|x| x * length), r.triple(5.0))
        }),
        answer: |angle: &Code, (a, b)| angle(vector(a), vector(b)),
    };
    Exercise {
        questions: vec![vectors.into()],
        picture: scene(|angle: &Code| Functions {
            angle: *angle,
            ..LESSON
        }),
        right: vec![Other::new("half the angle, in a rhombus", in_rhombus)],
        wrong: vec![
            Other::new("the cosine of a tiny angle rounds to 1", |a, b| {
                libm::acos(cosine(a, b).clamp(-1.0, 1.0))
            }),
            Other::new("the dot product contains both lengths", |a, b| {
                libm::acos(a.dot(b).clamp(-1.0, 1.0))
            }),
            Other::new("an obtuse angle has the sine of an acute one", |a, b| {
                libm::asin((1.0 - cosine(a, b) * cosine(a, b)).sqrt())
            }),
        ],
        ..Exercise::default()
    }
}

fn in_rhombus(a: Vector3, b: Vector3) -> f64 {
    let (a, b) = (a * b.magnitude(), b * a.magnitude());
    2.0 * libm::atan2((a - b).magnitude(), (a + b).magnitude())
}

fn cosine(a: Vector3, b: Vector3) -> f64 {
    a.dot(b) / (a.magnitude() * b.magnitude())
}
