//! Products of vectors, compared with the lesson's.

use glam::Vec3Swizzles;

use crate::prelude::*;

type Product<T> = fn(Vector3, Vector3) -> T;

pub fn check(check: &mut Check, dot: Product<f64>, cross: Product<Vector3>) {
    let [x, y] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let both = |dot: f64, cross: Vector3| {
        Answer::named("a · b", dot).and("a × b", cross.to_glam().to_array())
    };
    check.compare(
        "a = {}, b = {}",
        [(x, y), (y, x), ([1.0, 2.0, 3.0], [4.0, 5.0, 6.0])],
        random(|r| (r.triple(9.0), r.triple(9.0))),
        |(a, b)| both(vector(a).dot(vector(b)), vector(a).cross(vector(b))),
        |(a, b)| both(dot(vector(a), vector(b)), cross(vector(a), vector(b))),
    );
    scene(check, |f| (f.dot, f.cross) = (dot, cross));
}

pub const VARIANTS: &[Variant] = &[
    right("with shifted coordinates", |c| {
        let dot = |a: Vector3, b: Vector3| (a.to_glam() * b.to_glam()).element_sum();
        check(c, dot, |a, b| {
            let (a, b) = (a.to_glam(), b.to_glam());
            Vector3::from_glam((a * b.yzx() - a.yzx() * b).yzx())
        });
    }),
    wrong("a vector has three coordinates", |c| {
        check(c, |a, b| a.x() * b.x() + a.y() * b.y(), Vector3::cross);
    }),
    wrong("a × b is not b × a", |c| {
        check(c, Direction::dot, |a, b| b.cross(a));
    }),
    wrong("each coordinate is made of the two others", |c| {
        check(c, Direction::dot, |a, b| {
            Vector3::from_glam(a.to_glam() * b.to_glam())
        });
    }),
];
