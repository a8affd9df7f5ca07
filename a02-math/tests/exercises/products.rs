//! Products of vectors, compared with the lesson's.

use glam::Vec3Swizzles;

use crate::prelude::*;

pub fn dot(a: Vector3, b: Vector3) -> f64 {
    a.dot(b)
}

pub fn cross(a: Vector3, b: Vector3) -> Vector3 {
    a.cross(b)
}

type Product<T> = fn(Vector3, Vector3) -> T;

pub fn check(check: &mut Check, dot: Product<f64>, cross: Product<Vector3>) {
    let [x, y] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    check.compare(
        "a = {}, b = {}",
        [(x, y), (y, x), ([1.0, 2.0, 3.0], [4.0, 5.0, 6.0])],
        random(|r| (r.triple(9.0), r.triple(9.0))),
        [(Vector3::dot as _, Vector3::cross as _), (dot, cross)],
        |(dot, cross), (a, b)| {
            let (a, b) = (vector(a), vector(b));
            Answer::named("a · b", dot(a, b)).and("a × b", cross(a, b).to_glam().to_array())
        },
    );
    scene(check, |f| (f.dot, f.cross) = (dot, cross));
}

variants! { check:
    yours => dot, cross;
    right "with shifted coordinates" => |a, b| (a.to_glam() * b.to_glam()).element_sum(), |a, b| {
        let (a, b) = (a.to_glam(), b.to_glam());
        Vector3::from_glam((a * b.yzx() - a.yzx() * b).yzx())
    };
    wrong "a vector has three coordinates" => |a, b| a.x() * b.x() + a.y() * b.y(), Vector3::cross;
    wrong "a × b is not b × a" => Direction::dot, |a, b| b.cross(a);
    wrong "each coordinate is made of the two others" => Direction::dot, |a, b| {
        Vector3::from_glam(a.to_glam() * b.to_glam())
    };
}
