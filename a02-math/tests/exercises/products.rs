//! Products of vectors, compared with the lesson's.

use glam::Vec3Swizzles;

use crate::prelude::*;

yours! { dot, cross => crate::products::Code { dot, cross } }

#[derive(Clone, Copy)]
pub struct Code {
    pub dot: fn(Vector3, Vector3) -> f64,
    pub cross: fn(Vector3, Vector3) -> Vector3,
}

type Other = Variant<Code>;

pub fn dot(a: Vector3, b: Vector3) -> f64 {
    a.dot(b)
}

pub fn cross(a: Vector3, b: Vector3) -> Vector3 {
    a.cross(b)
}

pub fn exercise() -> Exercise<Code> {
    let [x, y] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let vectors = Questions {
        words: "a = {}, b = {}".into(),
        simple: vec![(x, y), (y, x), ([1.0, 2.0, 3.0], [4.0, 5.0, 6.0])],
        others: random(|r| (r.triple(9.0), r.triple(9.0))),
        answer: |code: &Code, (a, b)| {
            let (a, b) = (vector(a), vector(b));
            Answer::named("a · b", (code.dot)(a, b))
                .and("a × b", (code.cross)(a, b).to_glam().to_array())
        },
    };
    Exercise {
        questions: vec![vectors.into()],
        picture: scene(|code: &Code| Functions {
            dot: code.dot,
            cross: code.cross,
            ..LESSON
        }),
        right: vec![
            Other::new(
                "with shifted coordinates",
                Code {
                    dot: |a, b| (a.to_glam() * b.to_glam()).element_sum(),
                    cross: |a, b| {
                        let (a, b) = (a.to_glam(), b.to_glam());
                        Vector3::from_glam((a * b.yzx() - a.yzx() * b).yzx())
                    },
                },
            ),
            Other::new(
                "coordinate by coordinate",
                Code {
                    dot: dot_of_coordinates,
                    cross: cross_of_coordinates,
                },
            ),
        ],
        wrong: vec![
            Other::from_right("a vector has three coordinates", |right| Code {
                dot: |a, b| a.x() * b.x() + a.y() * b.y(),
                ..right
            }),
            Other::from_right("a × b is not b × a", |right| Code {
                cross: |a, b| b.cross(a),
                ..right
            }),
            Other::from_right("each coordinate is made of the two others", |right| Code {
                cross: |a, b| Vector3::from_glam(a.to_glam() * b.to_glam()),
                ..right
            }),
        ],
        ..Exercise::default()
    }
}

fn dot_of_coordinates(a: Vector3, b: Vector3) -> f64 {
    a.x() * b.x() + a.y() * b.y() + a.z() * b.z()
}

fn cross_of_coordinates(a: Vector3, b: Vector3) -> Vector3 {
    let x = a.y() * b.z() - a.z() * b.y();
    let y = a.z() * b.x() - a.x() * b.z();
    let z = a.x() * b.y() - a.y() * b.x();
    Vector3::new(x, y, z)
}
