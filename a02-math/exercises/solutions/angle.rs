//! `angle`: the lesson's own.

use a02_math::Vector3;

pub fn angle(a: Vector3, b: Vector3) -> f64 {
    a.angle(b)
}
